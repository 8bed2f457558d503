#include "core/render/line_of_sight.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace meltpool {

namespace {

/// Returns the distance of two segments, each from a point along a way; m or any unit.
float distanceBetween(const glm::vec3& from, const glm::vec3& way, const glm::vec3& otherFrom, const glm::vec3& other) {
    const glm::vec3 start = from - otherFrom;
    const float a = std::max(glm::dot(way, way), 1e-12f), e = std::max(glm::dot(other, other), 1e-12f);
    const float b = glm::dot(way, other), c = glm::dot(way, start), f = glm::dot(other, start);
    const float denominator = a * e - b * b;
    const float first = denominator > 1e-9f * a * e ? glm::clamp((b * f - c * e) / denominator, 0.0f, 1.0f) : 0.0f;
    const float second = glm::clamp((b * first + f) / e, 0.0f, 1.0f);
    const float again = glm::clamp((b * second - c) / a, 0.0f, 1.0f);
    return glm::length(start + way * again - other * second);
}

} // namespace

bool standsBefore(const Solid& solid, const glm::vec3& eye, const glm::vec3& target, float margin) {
    const glm::vec3 along(solid.toWorld[2]), middle(solid.toWorld[3]);
    const float width = std::max(glm::length(glm::vec3(solid.toWorld[0])), glm::length(glm::vec3(solid.toWorld[1])));
    const glm::vec3 from = solid.shape == SolidShape::bend ? middle : middle - 0.5f * along;
    return distanceBetween(from, along, eye, target - eye) < 0.5f * width + margin;
}

} // namespace meltpool
