// Rotation of a vector.
/// `arm` rotated by the rotation vector `rotation`, in rad (Rodrigues 1840).
vec3 rotated(vec3 arm, vec3 rotation) {
    float angle = length(rotation);
    if (angle < 1e-9) return arm + cross(rotation, arm);
    vec3 axis = rotation / angle;
    float halfSine = sin(0.5 * angle);
    return arm + sin(angle) * cross(axis, arm) + 2 * halfSine * halfSine * cross(axis, cross(axis, arm));
}
