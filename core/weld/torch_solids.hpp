// The torch as it is drawn: a few painted solids for each welding process.
#pragma once

#include "core/render/solids.hpp"
#include "core/weld/process.hpp"
#include "core/weld/torch_sample.hpp"

#include <vector>

namespace meltpool {

/// Replaces `solids` by the torch of this process at this pose; with the trigger pulled its arc or flame glows.
/// `workpieceToWorld`: rotation, one scale, translation.
void buildTorchSolids(std::vector<Solid>& solids, const TorchSample& torch, ProcessKind process,
                      const glm::mat4& workpieceToWorld);

} // namespace meltpool
