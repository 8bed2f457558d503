// A metal's surroundings in pictures, apart from the metal's own particles and surface.
#pragma once

#include "core/render/scene.hpp"
#include "core/weld/torch/torch_sample.hpp"

namespace meltpool {

class MetalScene {
  public:
    virtual ~MetalScene() = default;

    /// Returns the box of the particles, the meaning of their temperatures, the solids around them, and the torch or
    /// source at this pose; without particles and mesh. Lends solids that stay valid until the next call.
    virtual SceneView view(const TorchSample& torch) = 0;
};

} // namespace meltpool
