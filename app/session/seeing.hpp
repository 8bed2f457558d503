// The arc as an eye sees it, for the visor before it: one rule for the window and the headset.
#pragma once

#include "core/render/effects/worn_visor.hpp"
#include "core/render/line_of_sight.hpp"
#include "core/render/scene.hpp"
#include "core/render/view.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <span>

namespace meltpool {

/// Arc of this scene for an eye, or for the middle between two. `length`: m, of the arc.
inline SeenArc seenArc(const SceneView& scene, const View& eye, float length) {
    constexpr float kShortest = 1.6e-3f; // m, the least length that is drawn
    constexpr float kSight = 0.64f;      // cosine of 50 degrees: farther from the gaze an arc dazzles little
    SeenArc seen;
    seen.intensity = static_cast<double>(scene.arc.intensity.g);
    if (seen.intensity <= 0) return seen;
    seen.height = 0.5 * static_cast<double>(std::max(length, kShortest));
    const glm::vec3 world = scene.modelToWorld * glm::vec4(scene.arc.position, 1);
    seen.towards = glm::normalize(glm::mat3(eye.worldToEye) * (world - eye.eye));
    seen.inSight = -seen.towards.z > kSight;
    return seen;
}

/// Arc of this scene for a person with these eyes, `between` which its direction is taken. Torch, gloves and forearms
/// that hide all of it from both eyes keep it out of sight, as they keep its glare from the picture.
inline SeenArc seenArc(const SceneView& scene, const View& between, std::span<const View> eyes, float length) {
    SeenArc seen = seenArc(scene, between, length);
    seen.inSight = seen.inSight && std::any_of(eyes.begin(), eyes.end(),
                                               [&](const View& eye) { return arcPastHands(scene, eye.eye) > 0; });
    return seen;
}

} // namespace meltpool
