// The torch at one moment, from every front end: hand, mouse, script or recording.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace meltpool {

/// A filler rod in the other hand, in the workpiece's frame.
struct RodSample {
    glm::vec3 tip{0.0f};                           ///< m, place of its end while nothing of it has melted
    glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f}; ///< direction: its -Z; unit length
    float feed = 0;                                ///< m/s at which the fingers push it on through the hand

    glm::vec3 axis() const { return orientation * glm::vec3(0.0f, 0.0f, -1.0f); }
};

struct TorchSample {
    double time = 0;                               ///< s, since the lesson began
    glm::vec3 tip{0.0f};                           ///< m, workpiece frame: x along the seam, y out, z to the welder
    glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f}; ///< orientation of the torch in the workpiece frame; unit length
    float trigger = 0;                             ///< 0 released .. 1 pulled through
    std::optional<RodSample> rod = {};             ///< filler rod, while a second hand holds one
    bool seen = true; ///< false for a moment of a recorded path without pose: the torch is then at its last seen place

    /// Returns the unit vector from the handle to the tip, the direction of the torch.
    glm::vec3 axis() const { return orientation * glm::vec3(0.0f, 0.0f, -1.0f); }
};

} // namespace meltpool
