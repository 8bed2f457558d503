// Rotation of a vector.
/// `arm` turned about the rotation vector `turn` (Rodrigues).
vec3 turned(vec3 arm, vec3 turn) {
    float angle = length(turn);
    if (angle < 1e-9) return arm + cross(turn, arm);
    vec3 axis = turn / angle;
    float halfSine = sin(0.5 * angle);
    return arm + sin(angle) * cross(axis, arm) + 2 * halfSine * halfSine * cross(axis, cross(axis, arm));
}
