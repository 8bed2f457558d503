// The metal that obeys physics: heat, flow, solid fragments and filler over one state. step() is the algorithm.
#pragma once

#include "core/gl/readback.hpp"
#include "core/metal/flow/edge_arrest.hpp"
#include "core/metal/flow/flow.hpp"
#include "core/metal/heat/heat.hpp"
#include "core/metal/rigid_fragments.hpp"
#include "core/metal/state/particle_view.hpp"
#include "core/metal/state/statistics.hpp"
#include "shaders/shared/metal_statistics.h"

#include <optional>

namespace meltpool {

struct PhysicalSetup {
    Material material;
    MetalLattice lattice;
    std::vector<MetalSeed> seeds;
    size_t fillerRoom = 2048;               ///< particles that may be fed before the metal needs more memory
    size_t mostParticles = size_t(1) << 26; ///< filler beyond is refused; 2^26: the limit of slot numbers
    FlowSpace space;
    FragmentSetup fragments;
    HeatSettings heat;
    /// Pull along the surface by the slope of its tension. Particles of 0.5 to 1 mm do not resolve the layer of 0.1 mm
    /// that it drives in real pools: it drives the outermost particles, which are heavier, and so slower.
    bool marangoni = false;
    glm::vec3 gravity{0, -9.81F, 0}; ///< m/s², in the workpiece frame
    float timeStep = 1.0F / 90;      ///< s, of one step(), at most; see PhysicalMetal::timeStep()
    double wetting = 1;              ///< wetting of still metal by liquid metal, see FlowFluid
    EdgeArrest edge;                 ///< until setEdgeArrest()
};

class PhysicalMetal {
  public:
    /// Throws InputError if the material lacks data for flow or heat, RuntimeFault without GPU memory.
    PhysicalMetal(gl::ShaderLibrary& shaders, const PhysicalSetup& setup);

    /// Returns to the initial state: the same bits without allocating. The liquid's conductivity stays as set.
    void reset();

    /// Sets the liquid's heat conductivity from the next step on; all else of the material stays. The length of a step
    /// follows at the next reset.
    void setLiquidConductivity(const Property& conductivity);

    /// Makes one time step: filler enters, heat spreads in as many steps as conduction allows, liquid flows in as many
    /// as surface tension needs, free fragments move. Reads nothing back, except when filler needs more memory, once in
    /// thousands of particles. Filler that is outside the space, beyond the setup's most particles or beyond the
    /// driver's memory is refused and counted.
    void step(std::span<const HeatSource> sources, std::span<const MetalSeed> filler, gl::Profiler* profiler);

    /// Saves or restores all that the next step reads; the conductivity is the caller's. Restoring discards pending
    /// answers.
    void transfer(gl::StateArchive& archive);
    /// Replaces derivable values by their XOR with the derived value, mostly zero, so that they compress to nothing. A
    /// second call restores them to the bit. A state is saved and restored folded, and has no other use meanwhile.
    void xorOutDerivedState();

    /// Calls HeatSolver::setStirringLess(), with its condition on the setup's heat.
    void setStirringLess(glm::vec3 shares) { heat_->setStirringLess(shares); }
    /// Sets the arc's pressure from the next step on; none with a peak of 0.
    void setArc(const ArcPressure& arc) { flow_->setArc(arc); }

    /// Sets the arrest of the liquid's edge from the next step on, until a reset.
    void setEdgeArrest(const EdgeArrest& edge);

    /// Length of one step(), s. Shorter than the setup's if that saves a heat substep: one that is only a little too
    /// short would make two necessary.
    float timeStep() const { return timeStep_; }
    ParticleView particles() const {
        return {&state_->position,
                state_->particles(),
                nullptr,
                &state_->heat,
                &state_->frozenAt,
                &state_->lattice(),
                &state_->latticeSlots,
                static_cast<float>(setup_.material.solidus)};
    }
    const MetalState& state() const { return *state_; }
    const HeatTable& table() const { return table_; }
    const HeatSolver& heat() const { return *heat_; }
    const Flow& flow() const { return *flow_; }
    const RigidFragments& fragments() const { return *fragments_; }
    size_t refusedFiller() const { return refused_; } ///< particles since the reset

    MetalStatistics statistics(); ///< waits for the GPU
    /// Requests statistics; never waits. Throws RuntimeFault if kStatisticsInFlight answers are pending.
    void requestStatistics();
    /// The oldest answer that was not taken, if it has arrived; awaitStatistics() waits for it.
    std::optional<MetalStatistics> pollStatistics();
    std::optional<MetalStatistics> awaitStatistics();

    std::uint64_t stateHash() const; ///< waits for the GPU
    size_t bytes() const;

  private:
    using Parts = std::array<MetalPart, METAL_STATISTICS_PARTS>;

    void make();
    void begin();
    void setCapacity(size_t capacity);
    void reserve(size_t particles);
    void addFiller(std::span<const MetalSeed> filler);
    void gatherStatistics();
    MetalStatistics joined(const Parts& parts) const;

    gl::ShaderLibrary& shaders_;
    PhysicalSetup setup_;
    float timeStep_;
    std::optional<EdgeArrest> edge_; ///< the flow's; nothing: that of the restored state
    HeatTable table_;
    const gl::Program& count_;
    gl::Buffer parts_;
    gl::ReadbackQueue answers_;
    std::unique_ptr<MetalState> state_;
    std::unique_ptr<HeatSolver> heat_;
    std::unique_ptr<Flow> flow_;
    std::unique_ptr<RigidFragments> fragments_;
    size_t capacity_ = 0;             ///< particles that fit all buffers
    bool grows_ = true;               ///< false: the driver had no memory for more
    std::vector<MetalSeed> accepted_; ///< reused so that filler costs no allocation
    size_t refused_ = 0;
};

} // namespace meltpool
