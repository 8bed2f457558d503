// A fixed scene without simulation or extraction: a cube whose front corner has melted and sagged.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/render/scene.hpp"
#include "shaders/shared/surface.h"

#include <vector>

namespace meltpool::test {

class SyntheticScene {
  public:
    SyntheticScene();

    SceneView view() const;
    const std::vector<SurfaceVertex>& vertices() const { return vertices_; }

  private:
    std::vector<SurfaceVertex> vertices_;
    gl::Buffer vertexBuffer_;
    gl::Buffer indexBuffer_;
    gl::Buffer command_;
    gl::Buffer particles_;
    size_t particleCount_ = 0;
};

} // namespace meltpool::test
