// Implements poses, projections and their conversions.
#include "xr/pose.hpp"

#include <cmath>

namespace meltpool::xr {

glm::mat4 Pose::matrix() const {
    glm::mat4 m = glm::mat4_cast(orientation);
    m[3] = glm::vec4(position, 1.0f);
    return m;
}

glm::mat4 projection(const FieldOfView& fov, float nearZ, float farZ) {
    const float l = std::tan(fov.left), r = std::tan(fov.right), d = std::tan(fov.down), u = std::tan(fov.up);
    glm::mat4 m(0.0f);
    m[0][0] = 2.0f / (r - l);
    m[1][1] = 2.0f / (u - d);
    m[2][0] = (r + l) / (r - l);
    m[2][1] = (u + d) / (u - d);
    m[2][2] = -(farZ + nearZ) / (farZ - nearZ);
    m[2][3] = -1.0f;
    m[3][2] = -2.0f * farZ * nearZ / (farZ - nearZ);
    return m;
}

Pose interpolate(const Pose& a, const Pose& b, float t) {
    return {glm::slerp(a.orientation, b.orientation, t), glm::mix(a.position, b.position, t)};
}

Pose fromXr(const XrPosef& pose) {
    const XrQuaternionf& q = pose.orientation;
    return {glm::quat(q.w, q.x, q.y, q.z), glm::vec3(pose.position.x, pose.position.y, pose.position.z)};
}

XrPosef toXr(const Pose& pose) {
    const glm::quat& q = pose.orientation;
    return {{q.x, q.y, q.z, q.w}, {pose.position.x, pose.position.y, pose.position.z}};
}

FieldOfView fromXr(const XrFovf& fov) {
    return {fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown};
}

XrFovf toXr(const FieldOfView& fov) {
    return {fov.left, fov.right, fov.up, fov.down};
}

} // namespace meltpool::xr
