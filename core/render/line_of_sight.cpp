#include "core/render/line_of_sight.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

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

struct Axis {
    glm::vec3 from, to;
};

/// Returns the axis of the capsule that fits into a solid; for a bend its chord.
Axis axisIn(const Solid& solid) {
    const glm::vec3 x(solid.toWorld[0]), z(solid.toWorld[2]), middle(solid.toWorld[3]);
    if (solid.shape == SolidShape::bend)
        return {middle, middle + kBendRadius * ((1 - std::cos(kBendAngle)) * x + std::sin(kBendAngle) * z)};
    const float width = std::min(glm::length(x), glm::length(glm::vec3(solid.toWorld[1])));
    const float length = std::max(glm::length(z), 1e-9f);
    const glm::vec3 half = z * (0.5f - 0.5f * std::min(width, length) / length);
    return {middle - half, middle + half};
}

/// Returns half the width of a solid whose cross section is an ellipse, as a ray along `towards` meets it.
float halfWidthBefore(const Solid& solid, const glm::vec3& towards) {
    const glm::vec3 x(solid.toWorld[0]), y(solid.toWorld[1]);
    const glm::vec3 across = glm::cross(towards, glm::vec3(solid.toWorld[2]));
    const float length = glm::length(across);
    if (solid.shape == SolidShape::bend || length < 1e-9f) return 0.5f * std::min(glm::length(x), glm::length(y));
    return 0.5f * glm::length(glm::vec2(glm::dot(across, x), glm::dot(across, y))) / length;
}

/// Returns the share of a disc of radius 1 beyond a straight edge at this signed distance from its middle.
float discBeyond(float edge) {
    const float x = glm::clamp(edge, -1.0f, 1.0f);
    return 0.5f + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi_v<float>;
}

} // namespace

bool standsBefore(const Solid& solid, const glm::vec3& eye, const glm::vec3& target, float margin) {
    const glm::vec3 along(solid.toWorld[2]), middle(solid.toWorld[3]);
    const float width = std::max(glm::length(glm::vec3(solid.toWorld[0])), glm::length(glm::vec3(solid.toWorld[1])));
    const glm::vec3 from = solid.shape == SolidShape::bend ? middle : middle - 0.5f * along;
    return distanceBetween(from, along, eye, target - eye) < 0.5f * width + margin;
}

float seenPast(const Solid& solid, const glm::vec3& eye, const glm::vec3& light, float radius) {
    const auto [from, to] = axisIn(solid);
    const glm::vec3 towards = light - eye, axis = to - from, start = eye - from;
    // Nearest points of the axis, 0..1, and of the straight way to the light.
    const float square = std::max(glm::dot(axis, axis), 1e-12f), far = std::max(glm::dot(towards, towards), 1e-12f);
    const float turned = glm::dot(towards, axis), along = glm::dot(towards, start), below = glm::dot(axis, start);
    const float apart = std::max(far * square - turned * turned, 1e-9f * far * square);
    const float on = glm::clamp((below * far - along * turned) / apart, 0.0f, 1.0f);
    const float way = (turned * on - along) / far;
    if (way <= 0 || way >= 1) return 1; // behind the eye, or behind the light
    const float gap = glm::length(start + towards * way - axis * on);
    const float disc = std::max(radius * way, 1e-6f * std::sqrt(far)); // the light's cone there
    const float half = halfWidthBefore(solid, towards);
    return 1 - (discBeyond((gap + half) / disc) - discBeyond((gap - half) / disc));
}

float arcPastHands(const SceneView& scene, const glm::vec3& eye) {
    if (scene.hands.empty() || scene.arc.intensity.g <= 0) return 1;
    const glm::vec3 arc = scene.modelToWorld * glm::vec4(scene.arc.position, 1);
    const float radius = scene.arc.radius * glm::length(glm::vec3(scene.modelToWorld[0]));
    float share = 1;
    for (const Solid& fitting : scene.fittings) {
        share *= seenPast(fitting, eye, arc, radius);
        if (share <= 0) return 0;
    }
    return share;
}

} // namespace meltpool
