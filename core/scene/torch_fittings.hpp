// The finer solids of the torch in the hand: nozzle with its bore, gooseneck, handle, cable, and the gloved hands.
#pragma once

#include "core/render/solid.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <optional>
#include <vector>

namespace meltpool {

/// What the torch's cable and the hand depend on besides the pose, in the workpiece's frame.
struct TorchSurroundings {
    std::optional<glm::vec3> hand; ///< m, where the hand is; none: where a hand would hold this torch
    glm::vec3 cableEnd{0.0f};      ///< m, to which the cable hangs down from above
    glm::vec3 up{0, 1, 0};         ///< unit vector against gravity
};

/// Replaces `solids` by the torch of this process at this pose, as buildTorchModel() places it, whose coarse solids
/// they stand for; what of it is thin and moves (wire, electrode, arc, rod) is drawn by that. `workpieceToWorld`:
/// rotation, one scale, translation. Nothing of it comes nearer to the pose's tip than the torch itself, so that the
/// pool stays in sight.
void buildTorchFittings(std::vector<Solid>& solids, const TorchSample& torch, const ProcessSettings& process,
                        const TorchSurroundings& around, const glm::mat4& workpieceToWorld);

/// The way (unit vector) from the torch's head back along its handle, which is bent off the torch's axis by `angle`
/// (rad) to where it leans, or where it stands upright back against the travel and a little to the welder.
glm::vec3 handleWay(const TorchSample& torch, float angle);

} // namespace meltpool
