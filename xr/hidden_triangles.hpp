// Reads the parts of the eyes' pictures that the lenses do not show (XR_KHR_visibility_mask).
#pragma once

#include "xr/session.hpp"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace meltpool::xr {

/// Corners of both eyes' triangles, three a triangle, in the plane z = -1 of the eye.
struct HiddenTriangles {
    std::array<std::span<const glm::vec2>, 2> corners;
    std::uint64_t version = 0; ///< differs between masks and sessions; 0: no mask
};

/// Writes out a mesh of triangles, three corners each; leaves out triangles with an index beyond the vertices.
std::vector<glm::vec2> writeOut(std::span<const XrVector2f> vertices, std::span<const uint32_t> indices);

/// The masks of one session.
class HiddenMasks {
  public:
    /// Reads both eyes' masks; none where the runtime has no extension or mask. Allocates.
    void read(const Session& session);
    HiddenTriangles triangles() const { return {{corners_[0], corners_[1]}, version_}; }

  private:
    std::array<std::vector<glm::vec2>, 2> corners_;
    std::uint64_t version_ = 0;
};

} // namespace meltpool::xr
