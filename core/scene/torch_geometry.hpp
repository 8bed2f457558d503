// Lengths of the drawn torches, from which the headset's place of the tip in the hand follows.
#pragma once

#include "core/weld/process/processes.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace meltpool {

/// A torch from its tip back to the hand; m and rad.
struct TorchGeometry {
    float reach = 0;      ///< from the pose's tip to the torch's own front, before which wire, flame or electrode is
    float neck = 0;       ///< from the pose's tip along the axis to the place where the neck turns
    float bend = 0;       ///< angle between the torch's axis and its handle
    float bendRadius = 0; ///< radius of the neck's middle line; 0: a corner. A round neck turns by kBendAngle.
    float lead = 0;       ///< from the end of the bend to the beginning of the handle
    float handle = 0;     ///< length of the handle
    float handleWidth = 0;

    /// Returns the distance from the beginning of the handle to the middle of the hand.
    float held() const { return 0.55f * handle; }
    /// Returns the place of the tip in the hand's frame: the handle runs through its origin along z, its neck at -z,
    /// and the neck turns to -y. OpenXR's grip pose is such a frame.
    glm::vec3 tip() const;
    /// Returns the orientation of a torch's pose in that frame; see TorchSample::orientation.
    glm::quat tipOrientation() const;
};

/// Returns the geometry of the torch of this process at these settings.
TorchGeometry torchGeometry(const ProcessSettings& process);

/// The torch without a process: that of the classic lesson and of pictures with low detail.
constexpr TorchGeometry kPlainTorch{.neck = 0.083f, .bend = 0.7853982f, .handle = 0.19f, .handleWidth = 0.026f};

} // namespace meltpool
