// The metal's surface as triangles on the GPU.
#pragma once

#include "core/gl/buffer.hpp"

namespace meltpool {

/// Borrowed from the Surface that made it; valid until that is updated or gone.
struct SurfaceMesh {
    const gl::Buffer* vertices = nullptr;    ///< SurfaceVertex: vec4 position and temperature, vec4 normal
    const gl::Buffer* indices = nullptr;     ///< GLuint, three a triangle, counter-clockwise from outside
    const gl::Buffer* drawCommand = nullptr; ///< one DrawElementsIndirectCommand
    /// One float a vertex: the highest temperature so far, K. Null where nobody keeps it.
    const gl::Buffer* peaks = nullptr;
};

} // namespace meltpool
