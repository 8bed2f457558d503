// Finds the metal along an axis from the particles of the step, and answers a fixed number of steps later.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/gl/readback.hpp"
#include "core/metal/heat/heat.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/axis_probe.h"

#include <array>
#include <memory>
#include <optional>

namespace meltpool {

/// A ray to search along: origin (m), unit vector, reach (m).
struct ProbeRay {
    glm::vec3 origin{0};
    glm::vec3 axis{0, -1, 0};
    float reach = 0.05F;
};

/// The metal that the ray meets.
struct MetalOnAxis {
    ProbeRay ray;                  ///< the searched ray
    std::optional<float> distance; ///< m from the origin to the surface; empty: none within reach
    float liquid = 0;              ///< 0..1, share of liquid over a spacing or two behind the surface
};

/// Counts particles within two spacings of the axis, with a weight that falls to the side, in bins along it; the
/// surface is where half of the count inside solid metal is reached. On a flat surface, upright or slanted, this is the
/// surface's position to a tenth of a spacing; drops that fly along the axis do not count. If half is reached nowhere,
/// as over a gap between two plates, their edges are the surface, provided that they are at least three spacings deep:
/// an arc burns to the nearest metal. Sums are integers: equal metal gives equal answers.
class AxisProbe {
  public:
    /// Steps between a search and its answer: the answer does not depend on the speed of the GPU, and is hardly ever
    /// waited for.
    static constexpr size_t kDelay = 4;

    AxisProbe(gl::ShaderLibrary& shaders, const MetalState& state, const HeatSolver& heat);

    /// Returns to the initial state without allocating.
    void reset();

    /// Saves or restores the results that were not returned.
    void transfer(gl::StateArchive& archive);

    /// Searches the metal after the commands issued so far. Call it once a step.
    void look(const ProbeRay& ray, gl::Profiler* profiler);

    /// The answer to the search kDelay searches ago; nothing before that many. Waits for the GPU if that has not
    /// finished it.
    std::optional<MetalOnAxis> answer();

    size_t bytes() const;

  private:
    struct Pending {
        Pending() : readback("axis probe", sizeof(AxisProbeAnswer)) {}
        ProbeRay ray;
        gl::Readback readback;
    };

    AxisProbeBlock blockOf(const ProbeRay& ray) const;

    const MetalState& state_;
    const HeatSolver& heat_;
    const gl::Program& count_;
    const gl::Program& find_;
    gl::Buffer blockBuffer_, bins_, answer_;
    std::array<Pending, kDelay> pending_;
    size_t looks_ = 0;
    float full_;
};

} // namespace meltpool
