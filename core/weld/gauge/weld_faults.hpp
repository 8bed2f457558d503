// The metal that is missing beside or under a weld's surface: undercut, underfill, root concavity.
#pragma once

#include "core/weld/gauge/weld_shape.hpp"

namespace meltpool {

/// Returns the greatest depth of the metal's surface under a face of the workpiece over a stretch of the face, seen
/// from outside, m; 0 if the surface is nowhere under it. Places without any metal, and those nearer than one and a
/// half spacings to the outline's ends along the face, whose corners the particles' size rounds, are left out. Nothing
/// if that leaves no place of the stretch. `spacing` as for measureBead().
std::optional<double> grooveDepth(const WeldOutline& outline, const PlateFace& face, const FaceStretch& stretch,
                                  double spacing);

/// Returns the depth of the grooves beside a weld that covers `weld` of a face, m, at its low and at its high end: from
/// half a spacing inside each toe to `kUndercutReach` outside. ISO 6520-1 no. 501.
std::array<std::optional<double>, 2> undercutBeside(const WeldOutline& outline, const PlateFace& face,
                                                    const FaceStretch& weld, double spacing);

/// Returns the depth of the grooves beside a fillet, m: on the faces of the base plate and the upright plate. `base`
/// as for measureFillet().
std::array<std::optional<double>, 2> undercutBeside(const WeldOutline& outline, const PlateFace& base,
                                                    const FilletShape& fillet, double spacing);

/// Distance from a toe within which a groove is looked for, spacings and m; the greater of both counts.
inline constexpr double kUndercutReachSpacings = 3;
inline constexpr double kUndercutReach = 2e-3;

} // namespace meltpool
