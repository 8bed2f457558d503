// The finer solids of the torch in the hand: nozzle with its bore, gooseneck, handle, cable, and the gloved hands.
#pragma once

#include "core/render/solid.hpp"
#include "core/scene/gloved_hand.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <optional>
#include <vector>

namespace meltpool {

/// Inputs of the torch's cable and the hand other than the pose, in the workpiece's frame.
struct TorchSurroundings {
    /// Hand through which the handle runs; none: the usual place on this torch. A torch whose neck is longer than the
    /// way to the hand is drawn shorter, or straight.
    std::optional<TrackedHand> hand;
    bool rightHand = false;   ///< without a `hand`: the handle leads to the welder's right hand, else to the left one
    glm::vec3 cableEnd{0.0f}; ///< m, end of the cable, which hangs down to it from above
    glm::vec3 up{0, 1, 0};    ///< unit vector against gravity
};

/// Replaces `solids` by the torch of this process at this pose, as buildTorchModel() places it; they replace its coarse
/// solids, while its thin moving parts (wire, electrode, arc, rod) are still drawn by it. `workpieceToWorld`: rotation,
/// one scale, translation. No part comes nearer to the pose's tip than the torch itself, so that the pool stays in
/// sight.
void buildTorchFittings(std::vector<Solid>& solids, const TorchSample& torch, const ProcessSettings& process,
                        const TorchSurroundings& around, const glm::mat4& workpieceToWorld);

/// Returns the direction (unit vector) from the torch's head back along its handle, which is bent off the torch's axis
/// by `angle` (rad) in its leaning direction, or for an upright torch to the welder's left, or `right`, and a little to
/// the welder.
glm::vec3 handleWay(const TorchSample& torch, float angle, bool right);

} // namespace meltpool
