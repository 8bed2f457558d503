// The drawn torch: a few painted solids for each welding process.
#pragma once

#include "core/render/scene.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <vector>

namespace meltpool {

/// Replaces `solids` by the torch of this process at this pose; the wire has its present extension, and a burning arc
/// or flame glows. Returns the number of last solids that are a filler rod, see holdsRod(). `workpieceToWorld`:
/// rotation, one scale, translation.
size_t buildTorchModel(std::vector<Solid>& solids, const TorchSample& torch, const ProcessSettings& process,
                       const ArcState& arc, const glm::mat4& workpieceToWorld);

/// Returns the light of this arc in the workpiece's frame (m); none for processes without an arc or while none burns.
/// Its luminous flux is taken as 5 lm for each watt of V I, which gives some 6 klx at half a metre for 200 A: an
/// estimate, as no two arcs shine alike.
ArcLight torchArcLight(const TorchSample& torch, const ProcessSettings& process, const ArcState& arc);

} // namespace meltpool
