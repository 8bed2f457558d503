// Whether a solid keeps something out of an eye's sight.
#pragma once

#include "core/render/solid.hpp"

namespace meltpool {

/// Whether a solid along its z axis, as wide as it is, comes within `margin` (world units) of the line from `eye` to
/// `target`, or of the eye itself; both in world units.
bool standsBefore(const Solid& solid, const glm::vec3& eye, const glm::vec3& target, float margin);

} // namespace meltpool
