// The drawn torch: a few painted solids for each welding process, and the light of its arc.
#pragma once

#include "core/render/scene.hpp"
#include "core/weld/process/process.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <vector>

namespace meltpool {

/// Replaces `solids` by the torch of this process at this pose, with its arc or flame while the trigger is pulled.
/// `workpieceToWorld`: rotation, one scale, translation.
void buildTorchModel(std::vector<Solid>& solids, const TorchSample& torch, const ProcessParameters& process,
                     const glm::mat4& workpieceToWorld);

/// Light of the torch's arc in the workpiece's frame (m); intensity 0 for processes without an arc or with the trigger
/// released. The luminous flux is estimated as 5 lm per watt of V I: about 6 klx at half a metre for 200 A.
ArcLight torchArcLight(const TorchSample& torch, const ProcessParameters& process);

} // namespace meltpool
