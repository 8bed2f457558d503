// Tests for solids in an eye's line of sight.
#pragma once

#include "core/render/scene.hpp"
#include "core/render/solid.hpp"

namespace meltpool {

/// Returns true if a solid along its z axis, with its width, comes within `margin` (world units) of the line from `eye`
/// to `target`, or of the eye itself; both in world units.
bool standsBefore(const Solid& solid, const glm::vec3& eye, const glm::vec3& target, float margin);

/// Returns the share of a round light that an eye sees past a solid: 1 all of it, 0 none. The solid counts as a
/// capsule along its z axis that fits into it, and as a strip of that width before the light's disc. World units.
float seenPast(const Solid& solid, const glm::vec3& eye, const glm::vec3& light, float radius);

/// Returns the share of the scene's arc that an eye sees past torch, gloves and forearms of a person whose hands are
/// tracked. A free camera looks through hands that come near it: without tracked hands the share is 1.
float arcPastHands(const SceneView& scene, const glm::vec3& eye);

} // namespace meltpool
