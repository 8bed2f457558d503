// Probe that finds the metal's surface around a point on the GPU; the answer arrives frames later without waiting.
#pragma once

#include "core/gl/readback.hpp"
#include "core/surface/surface.hpp"
#include "shaders/shared/surface_probe.h"

#include <optional>

namespace meltpool {

/// A query, in the surface's model units.
struct ProbeAim {
    glm::vec3 point{0};
    glm::vec3 axis{0, -1, 0}; ///< unit vector
    float reach = 1;          ///< greatest distance searched
};

/// Query of the drawn surface: that of the Surface's last update. One query at a time: a request while another is
/// pending is dropped.
class SurfaceProbe {
  public:
    explicit SurfaceProbe(gl::ShaderLibrary& shaders);

    void request(const Surface& surface, const ProbeAim& aim);
    /// Returns the answer when it has arrived, once; never waits.
    std::optional<SurfaceProbeAnswer> poll();
    /// Drops the pending request, for metal that is replaced.
    void forget() {
        readback_.forget();
        pending_ = false;
    }
    /// Returns the answer at once; waits for the GPU.
    SurfaceProbeAnswer now(const Surface& surface, const ProbeAim& aim);

  private:
    void dispatch(const Surface& surface, const ProbeAim& aim);

    const gl::Program& program_;
    gl::Buffer answer_;
    gl::Readback readback_;
    bool pending_ = false;
};

} // namespace meltpool
