// The part of `meltpool doctor --speed` that welds for some seconds and finds the particle spacing that this machine
// can keep up with.
#pragma once

#include "app/commands/doctor.hpp"
#include "core/gl/program.hpp"
#include "core/training/lesson/lesson.hpp"

#include <optional>
#include <span>

namespace meltpool {

/// Speed of the metal's steps alone, without pictures.
struct WeldSpeed {
    float spacingMm = 0;
    double ratio = 0; ///< simulated over real time
};

/// Welds the lesson's demonstration for `warmUp` s of real time, which do not count, then for `seconds` more.
WeldSpeed measureWeldSpeed(gl::ShaderLibrary& shaders, const Lesson& lesson, double warmUp, double seconds);

/// Finest of the spacings whose steps leave at least a fifth of the time to picture and window; nothing if there is
/// none.
std::optional<float> bearableSpacing(std::span<const WeldSpeed> speeds);

/// Finding for the speeds, measured from the finest spacing on. At least one.
Finding speedFinding(std::span<const WeldSpeed> speeds);

/// Measures `gmaw-bead` at its own spacing and, if that is too fine, at coarser ones; ten seconds in all at most, apart
/// from compiling shaders.
void inspectSpeed(std::vector<Finding>& findings);

} // namespace meltpool
