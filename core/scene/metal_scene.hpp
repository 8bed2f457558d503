// A metal's surroundings in pictures, apart from the metal's own particles and surface.
#pragma once

#include "core/render/scene.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <vector>

namespace meltpool {

class MetalScene {
  public:
    virtual ~MetalScene() = default;

    /// Returns the box of the particles, the meaning of their temperatures, the solids around them, and the torch or
    /// source at this pose; without particles and mesh. Lends solids that stay valid until the next call.
    virtual SceneView view(const TorchSample& torch) = 0;

    /// Adds the holders of a workpiece that is held `overTable` (m) over a table, in the world of view(), instead of
    /// those of its furniture. A metal without a workpiece has none.
    virtual void addHolders(std::vector<Solid>& /*solids*/, float /*overTable*/) const {}
};

} // namespace meltpool
