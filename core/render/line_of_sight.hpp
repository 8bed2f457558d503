// Test for a solid in an eye's line of sight.
#pragma once

#include "core/render/solid.hpp"

namespace meltpool {

/// Returns true if a solid along its z axis, with its width, comes within `margin` (world units) of the line from `eye`
/// to `target`, or of the eye itself; both in world units.
bool standsBefore(const Solid& solid, const glm::vec3& eye, const glm::vec3& target, float margin);

} // namespace meltpool
