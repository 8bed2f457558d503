// The part of `meltpool doctor --speed` that welds for some seconds and tells which particle spacing this machine
// bears.
#pragma once

#include "app/commands/doctor.hpp"
#include "core/gl/program.hpp"
#include "core/training/lesson/lesson.hpp"

#include <optional>
#include <span>

namespace meltpool {

/// How fast the metal's steps alone go, without pictures.
struct WeldSpeed {
    float spacingMm = 0;
    double ratio = 0; ///< simulated over real time
};

/// Welds the lesson's demonstration for `warmUp` s of real time, which do not count, then for `seconds` more.
WeldSpeed measureWeldSpeed(gl::ShaderLibrary& shaders, const Lesson& lesson, double warmUp, double seconds);

/// The finest of the spacings whose steps leave at least a fifth of the time to picture and window; none where none
/// does.
std::optional<float> bearableSpacing(std::span<const WeldSpeed> speeds);

/// What is told of the speeds, measured from the finest spacing on. At least one.
Finding speedFinding(std::span<const WeldSpeed> speeds);

/// Measures `gmaw-bead` at its own spacing and, where that is too fine, at coarser ones; ten seconds in all at most,
/// the making of shaders aside.
void inspectSpeed(std::vector<Finding>& findings);

} // namespace meltpool
