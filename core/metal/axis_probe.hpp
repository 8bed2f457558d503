// Finds the metal along an axis, from the particles of the step itself, and answers a fixed number of steps later.
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

/// Where to look: m, a unit vector, m.
struct ProbeRay {
    glm::vec3 origin{0};
    glm::vec3 axis{0, -1, 0};
    float reach = 0.05F;
};

/// The metal that a look met.
struct MetalOnAxis {
    ProbeRay ray;                  ///< of the look
    std::optional<float> distance; ///< m from the origin to the surface; nothing where there is none within reach
    float liquid = 0;              ///< 0..1, share of liquid over a spacing or two behind the surface
};

/// A look counts particles within two spacings of the axis, with a weight that falls to the side, in bins along it; the
/// surface is where half of the count inside solid metal is reached. On a flat surface that is its place to a tenth of
/// a spacing, upright or slanted; drops that fly along the axis are not taken for it. Where half is reached nowhere, as
/// over a gap between two plates, their edges are the surface, where they are at least three spacings deep: an arc
/// burns to the nearest metal. Sums are integers: the same metal gives the same answer.
class AxisProbe {
  public:
    /// Steps between a look and its answer, so that the answer is the same whether the GPU is fast or slow, and hardly
    /// ever waited for.
    static constexpr size_t kDelay = 4;

    AxisProbe(gl::ShaderLibrary& shaders, const MetalState& state, const HeatSolver& heat);

    /// As new, in the same memory.
    void reset();

    /// Saves or restores what was found and not told yet.
    void transfer(gl::StateArchive& archive);

    /// Looks at the metal as the commands so far leave it. Once a step.
    void look(const ProbeRay& ray, gl::Profiler* profiler);

    /// The answer to the look of kDelay looks ago; nothing before that many. Waits for the GPU where it has not come
    /// that far.
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
