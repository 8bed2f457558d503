// The torch as it is drawn: a few painted solids for each welding process.
#pragma once

#include "core/render/scene.hpp"
#include "core/weld/process/process.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <vector>

namespace meltpool {

/// Replaces `solids` by the torch of this process at this pose; with the trigger pulled its arc or flame glows.
/// `workpieceToWorld`: rotation, one scale, translation.
void buildTorchSolids(std::vector<Solid>& solids, const TorchSample& torch, const ProcessParameters& process,
                      const glm::mat4& workpieceToWorld);

/// The light of this torch's arc in the workpiece's frame (m); none for processes without an arc or with the trigger
/// released. Its luminous flux is taken as 5 lm for each watt of V I, which gives some 6 klx at half a metre for
/// 200 A: an estimate, as no two arcs shine alike.
ArcLight torchArc(const TorchSample& torch, const ProcessParameters& process);

} // namespace meltpool
