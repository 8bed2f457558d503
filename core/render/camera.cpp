#include "core/render/camera.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kHalfTurn = 3.14159265358979f;
constexpr float kSteepest = kHalfTurn / 2 - kPoleMargin;
constexpr glm::vec3 kUp{0, 1, 0};

/// Returns an equal angle in -pi .. pi, so that long turning loses no precision.
float wrapped(float angle) {
    return std::remainder(angle, 2 * kHalfTurn);
}

/// Returns yaw about the world's up axis after pitch about the camera's right axis: without roll.
glm::quat withoutRoll(float yaw, float pitch) {
    return glm::angleAxis(yaw, kUp) * glm::angleAxis(pitch, glm::vec3(1, 0, 0));
}

} // namespace

Viewport columnOf(const Viewport& whole, int column, int columns) {
    const int width = whole.width / columns;
    return {whole.x + width * column, whole.y, width, whole.height};
}

View makeView(const glm::vec3& position, const glm::quat& orientation, const Lens& lens, float aspect) {
    View view;
    const glm::mat4 eyeToWorld = glm::translate(glm::mat4(1.0f), position) * glm::mat4_cast(orientation);
    view.worldToEye = glm::inverse(eyeToWorld);
    view.eyeToClip = glm::perspective(lens.fieldOfView, aspect, lens.nearest, lens.farthest);
    view.eye = position;
    return view;
}

FreeCamera::FreeCamera(const glm::vec3& position, const glm::vec3& target) : position_(position) {
    const glm::vec3 way = target - position;
    yaw_ = std::atan2(-way.x, -way.z);
    pitch_ = std::clamp(std::atan2(way.y, std::hypot(way.x, way.z)), -kSteepest, kSteepest);
}

void FreeCamera::look(const glm::vec2& turn) {
    yaw_ = wrapped(yaw_ - turn.x);
    pitch_ = std::clamp(pitch_ + turn.y, -kSteepest, kSteepest);
}

void FreeCamera::move(const glm::vec3& way) {
    position_ += right() * way.x + kUp * way.y + forward() * way.z;
}

glm::quat FreeCamera::orientation() const {
    return withoutRoll(yaw_, pitch_);
}

glm::vec3 FreeCamera::forward() const {
    return orientation() * glm::vec3(0, 0, -1);
}

glm::vec3 FreeCamera::right() const {
    return orientation() * glm::vec3(1, 0, 0);
}

View FreeCamera::view(const Lens& lens, float aspect) const {
    return makeView(position_, orientation(), lens, aspect);
}

OrbitCamera::OrbitCamera(float azimuth, float elevation, float distance, const glm::vec3& target)
    : azimuth_(wrapped(azimuth)),
      elevation_(std::clamp(elevation, -kSteepest, kSteepest)),
      distance_(std::clamp(distance, kNearest, kFarthest)),
      target_(target) {}

void OrbitCamera::orbit(const glm::vec2& turn) {
    azimuth_ = wrapped(azimuth_ + turn.x);
    elevation_ = std::clamp(elevation_ + turn.y, -kSteepest, kSteepest);
}

void OrbitCamera::approach(float factor) {
    distance_ = std::clamp(distance_ * factor, kNearest, kFarthest);
}

glm::vec3 OrbitCamera::position() const {
    return target_ - forward() * distance_;
}

glm::quat OrbitCamera::orientation() const {
    return withoutRoll(azimuth_, -elevation_);
}

glm::vec3 OrbitCamera::forward() const {
    return orientation() * glm::vec3(0, 0, -1);
}

glm::vec3 OrbitCamera::right() const {
    return orientation() * glm::vec3(1, 0, 0);
}

View OrbitCamera::view(const Lens& lens, float aspect) const {
    return makeView(position(), orientation(), lens, aspect);
}

} // namespace meltpool
