// Looks where the metal's surface lies around a point: the GPU answers frames later, nothing waits.
#pragma once

#include "core/gl/readback.hpp"
#include "core/surface/surface.hpp"
#include "shaders/shared/surface_probe.h"

#include <optional>

namespace meltpool {

/// Where to look, in the surface's model units.
struct ProbeAim {
    glm::vec3 point{0};
    glm::vec3 axis{0, -1, 0}; ///< unit vector
    float reach = 1;          ///< how far to look
};

/// Where the surface is, in model units. Distances are negative inside the metal and the reach where there is none.
struct SurfaceSounding {
    float ahead = 0;       ///< along the axis; from inside: back along it
    float nearest = 0;     ///< in 64 evenly spread directions: before a flat face up to a tenth too far
    float temperature = 0; ///< where the axis meets the metal (inside: at the point), as the surface shows it
    glm::vec3 normal{0};   ///< outward unit normal at the nearest place
};

/// Looks at a Surface as it was last updated; what is drawn is what is met. One look at a time: one asked for while
/// another is under way is dropped.
class SurfaceProbe {
  public:
    explicit SurfaceProbe(gl::ShaderLibrary& shaders);

    void request(const Surface& surface, const ProbeAim& aim);
    /// The answer, once, when it has arrived; never waits.
    std::optional<SurfaceSounding> poll();
    /// Waits for the GPU.
    SurfaceSounding now(const Surface& surface, const ProbeAim& aim);

  private:
    void look(const Surface& surface, const ProbeAim& aim);

    const gl::Program& program_;
    gl::Buffer answer_;
    gl::Readback readback_;
    bool underWay_ = false;
};

} // namespace meltpool
