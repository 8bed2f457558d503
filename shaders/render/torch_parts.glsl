// The torch as a few cylinders: its image in a pool, and its shadow in the lamp's light.
#ifndef MELTPOOL_RENDER_TORCH_PARTS_GLSL
#define MELTPOOL_RENDER_TORCH_PARTS_GLSL

#include "render/arc.glsl"

// Reflectance of the plate in a pool's mirror image. None: chosen, between clean and scaled steel.
const float kMirroredPlate = 0.25;

struct Mirrored {
    float distance; // distance along the ray, world units
    vec3 normal;
    vec3 colour;
};

// Replaces `nearest` by the torch part if the ray from `at` meets that first. `towards`: unit.
void meetPart(TorchPart part, vec3 at, vec3 towards, inout Mirrored nearest) {
    vec3 axis = part.to - part.from;
    float whole = length(axis);
    axis /= whole;
    vec3 start = at - part.from;
    float along = dot(start, axis), perDistance = dot(towards, axis);
    vec3 across = start - axis * along, acrossPer = towards - axis * perDistance;
    float a = max(dot(acrossPer, acrossPer), 1e-9), b = dot(across, acrossPer);
    float root = b * b - a * (dot(across, across) - part.radius * part.radius);
    // The end that faces the ray's start, then the side.
    float end = perDistance > 0.0 ? 0.0 : whole;
    float toEnd = (end - along) / (abs(perDistance) < 1e-6 ? 1e-6 : perDistance);
    vec3 onEnd = across + acrossPer * toEnd;
    float toSide = (-b - sqrt(max(root, 0.0))) / a, height = along + perDistance * toSide;
    bool meetsEnd = toEnd > 0.0 && dot(onEnd, onEnd) < part.radius * part.radius;
    bool meetsSide = root > 0.0 && toSide > 0.0 && height > 0.0 && height < whole;
    float distance_ = meetsEnd ? toEnd : toSide;
    if (!(meetsEnd || meetsSide) || distance_ >= nearest.distance) return;
    nearest.distance = distance_;
    nearest.normal = meetsEnd ? axis * (end > 0.0 ? 1.0 : -1.0) : (across + acrossPer * toSide) / part.radius;
    nearest.colour = part.colour;
}

// Replaces `nearest` by the workpiece's block if the ray meets that first. A ray that starts inside one does not meet
// it: a pool is in its own plate.
void meetBlock(ShadowBox block, vec3 at, vec3 towards, inout Mirrored nearest) {
    mat3 toModel = transpose(mat3(frame.modelToWorld)) / (frame.modelUnit * frame.modelUnit);
    vec3 start = toModel * (at - frame.modelToWorld[3].xyz), per = toModel * towards;
    vec3 inverse_ = 1.0 / mix(per, vec3(1e-9), lessThan(abs(per), vec3(1e-9)));
    vec3 toLow = (block.low - start) * inverse_, toHigh = (block.high - start) * inverse_;
    vec3 first = min(toLow, toHigh), last = max(toLow, toHigh);
    float entry = max(max(first.x, first.y), first.z);
    if (entry <= 0.0 || entry >= min(min(last.x, last.y), last.z) || entry >= nearest.distance) return;
    nearest.distance = entry;
    vec3 side = -sign(per) * vec3(equal(first, vec3(entry)));
    nearest.normal = normalize(mat3(frame.modelToWorld) * side);
    nearest.colour = vec3(kMirroredPlate);
}

// Mirror image at `at` in the direction `towards`: the torch and the workpiece in the light of arc and lamp, else the
// room.
vec3 mirroredThings(vec3 at, vec3 towards, vec3 room) {
    Mirrored nearest = Mirrored(1e9, vec3(0.0), vec3(0.0));
    for (int i = 0; i < frame.torchPartCount; ++i)
        meetPart(frame.torchParts[i], at, towards, nearest);
    for (int i = 0; i < frame.shadowBoxCount; ++i)
        meetBlock(frame.shadowBoxes[i], at, towards, nearest);
    if (nearest.distance >= 1e9) return room;
    vec3 place = at + towards * nearest.distance;
    vec3 lit = vec3(frame.ambient + frame.diffuse * max(dot(nearest.normal, frame.lampDirection), 0.0));
    return nearest.colour * (lit + arcDiffuse(frame.arc - place, nearest.normal));
}

#endif
