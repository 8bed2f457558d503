// What is missing beside or under a weld's surface: undercut, a surface that lies too low, a hollow root.
#pragma once

#include "core/weld/gauge/weld_shape.hpp"

namespace meltpool {

/// How deep the metal's surface lies under a face of the workpiece, seen from outside, m: the greatest depth over a
/// stretch of the face, 0 where the surface lies nowhere under it. Places without any metal, and those nearer than one
/// and a half spacings to the outline's ends along the face, whose corners the particles' size rounds, are left out.
/// Nothing where that leaves no place of the stretch. `spacing` as for measureBead().
std::optional<double> grooveDepth(const WeldOutline& outline, const PlateFace& face, const FaceStretch& stretch,
                                  double spacing);

/// Depth of the grooves beside a weld that covers `weld` of a face, m, at its low and at its high end: from half a
/// spacing inside each toe to `kUndercutReach` outside. ISO 6520-1 no. 501.
std::array<std::optional<double>, 2> undercutBeside(const WeldOutline& outline, const PlateFace& face,
                                                    const FaceStretch& weld, double spacing);

/// The same of a fillet: on the lying and on the standing face. `lying` as for measureFillet().
std::array<std::optional<double>, 2> undercutBeside(const WeldOutline& outline, const PlateFace& lying,
                                                    const FilletShape& fillet, double spacing);

/// How far from a toe a groove is looked for, spacings and m; the greater of both counts.
inline constexpr double kUndercutReachSpacings = 3;
inline constexpr double kUndercutReach = 2e-3;

} // namespace meltpool
