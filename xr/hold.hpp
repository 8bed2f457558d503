// Chooses the direction of a tool in the hand.
#pragma once

#include "xr/pose.hpp"

namespace meltpool::xr {

/// Greatest lean of the grip's -Z from the aim's at which a tool still follows the grip, in radians. On some
/// controllers the grip leans by 45 to 60 degrees, and a torch along it would point at the floor.
constexpr float kGreatestLean = 0.5236f; // 30 degrees

/// True if the grip leans so far from the aim that a tool follows the aim.
bool holdsByAim(const Pose& grip, const Pose& aim);

/// Rotation from the grip to a held tool: none, or the one to the aim.
glm::quat holdRotation(const Pose& grip, const Pose& aim);

} // namespace meltpool::xr
