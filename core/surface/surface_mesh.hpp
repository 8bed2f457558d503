// The metal's surface as triangles on the GPU.
#pragma once

#include "core/gl/buffer.hpp"

namespace meltpool {

/// Pointers to buffers of the Surface that made it; valid until that is updated or destroyed.
struct SurfaceMesh {
    const gl::Buffer* vertices = nullptr;    ///< SurfaceVertex
    const gl::Buffer* indices = nullptr;     ///< GLuint, three a triangle, counter-clockwise from outside
    const gl::Buffer* drawCommand = nullptr; ///< one DrawElementsIndirectCommand
    /// One float a vertex: the highest temperature so far, K. Null when the particles do not store it.
    const gl::Buffer* peaks = nullptr;
    /// One SurfaceFreezing a vertex. Null when the particles do not store when they froze, or when it was not
    /// requested.
    const gl::Buffer* freezing = nullptr;
};

} // namespace meltpool
