// Defines poses and fields of view, and their conversion to and from OpenXR's structs.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <openxr/openxr.h>

namespace meltpool::xr {

/// A place and a direction: metres, right-handed, y up; the pose's own -Z looks forward.
struct Pose {
    glm::quat orientation{1, 0, 0, 0};
    glm::vec3 position{0};

    glm::vec3 operator*(const glm::vec3& local) const { return position + orientation * local; }
    /// Applies `inner` first, then this one.
    Pose operator*(const Pose& inner) const { return {orientation * inner.orientation, *this * inner.position}; }
    Pose inverse() const {
        const glm::quat back = glm::conjugate(orientation);
        return {back, back * -position};
    }
    glm::vec3 forward() const { return orientation * glm::vec3(0, 0, -1); }
    glm::mat4 matrix() const;
};

/// Angles from the view axis in radians: left and down are negative in an ordinary headset. Not symmetric.
struct FieldOfView {
    float left = -0.7f;
    float right = 0.7f;
    float up = 0.7f;
    float down = -0.7f;
};

/// OpenGL clip space (z from -1 at `nearZ` to 1 at `farZ`, metres) for an asymmetric field of view.
glm::mat4 projection(const FieldOfView& fov, float nearZ, float farZ);

/// The pose at `t` (0..1) of the way from `a` to `b`: position linear, orientation along the shorter arc.
Pose interpolate(const Pose& a, const Pose& b, float t);

Pose fromXr(const XrPosef& pose);
XrPosef toXr(const Pose& pose);
FieldOfView fromXr(const XrFovf& fov);
XrFovf toXr(const FieldOfView& fov);

} // namespace meltpool::xr
