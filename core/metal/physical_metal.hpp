// The metal that obeys physics: heat, flow, solid fragments and filler over one state. step() is the algorithm.
#pragma once

#include "core/gl/readback.hpp"
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
    size_t mostParticles = size_t(1) << 26; ///< filler beyond is refused; 2^26: what numbers of slots bear
    FlowSpace space;
    FragmentSetup fragments;
    HeatSettings heat;
    /// Pull along the surface by the slope of its tension. Particles of 0.5 to 1 mm do not resolve the layer of 0.1 mm
    /// that it drives in real pools: it drives the outermost particles, which are heavier, and so slower.
    bool marangoni = false;
    glm::vec3 gravity{0, -9.81F, 0}; ///< m/s², in the workpiece frame
    float timeStep = 1.0F / 90;      ///< s, of one step(), at most; see PhysicalMetal::timeStep()
    double wetting = 1;              ///< of still metal by liquid metal, see FlowFluid
    double coldAngle = 0; ///< rad, contact angle on cold metal, see wettingForAngle(); 0: wets as warm metal does
    double coldShare = 0; ///< metal is cold up to this share of the solidus in K
    double warmShare = 1; ///< and warm from this share on
};

class PhysicalMetal {
  public:
    /// Throws InputError where the material lacks what flow or heat need, RuntimeFault without GPU memory.
    PhysicalMetal(gl::ShaderLibrary& shaders, const PhysicalSetup& setup);

    /// As new: the same bits in the same memory, but for the liquid's conductivity, which stays as it was set.
    void reset();

    /// The liquid conducts heat by these values from the next step on; all else of the material stays. The length of a
    /// step follows at the next reset.
    void setLiquidConductivity(const Property& conductivity);

    /// One time step: filler enters, heat spreads in as many steps as conduction allows, liquid flows in as many as
    /// surface tension needs, free fragments move. Nothing is read back, but where filler needs more memory,
    /// once in thousands of particles. Filler that is outside the space, beyond the setup's most particles or more than
    /// the driver has memory for is refused and counted.
    void step(std::span<const HeatSource> sources, std::span<const MetalSeed> filler, gl::Profiler* profiler);

    /// Saves or restores all that the next step reads; the conductivity is the caller's. Answers that are pending are
    /// dropped where it restores.
    void transfer(gl::StateArchive& archive);
    /// Folds away what follows from the rest of the state: it becomes the bits in which it differs from that, which are
    /// mostly none and pack to nothing. A second call unfolds it, to the bit. A state is saved and restored folded,
    /// and of no other use meanwhile.
    void fold();

    /// See HeatSolver::setStirringLess(); expects it of the setup's heat.
    void setStirringLess(glm::vec3 shares) { heat_->setStirringLess(shares); }
    /// Pressure of the arc from the next step on; none with a peak of 0.
    void setArc(const ArcPressure& arc) { flow_->setArc(arc); }

    /// Of one step(), s. Shorter than the setup's where that saves much heat: if one step of heat is only a little too
    /// short for it, two would be needed.
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
    /// Never waits. Throws RuntimeFault when kStatisticsInFlight answers are pending.
    void requestStatistics();
    /// The oldest answer that was not given yet; awaitStatistics() waits for it.
    std::optional<MetalStatistics> pollStatistics();
    std::optional<MetalStatistics> awaitStatistics();

    std::uint64_t stateHash() const; ///< waits for the GPU
    size_t bytes() const;

  private:
    using Parts = std::array<MetalPart, METAL_STATISTICS_PARTS>;

    void make();
    void begin();
    void setCapacity(size_t capacity);
    void makeRoom(size_t particles);
    void addFiller(std::span<const MetalSeed> filler);
    void gatherStatistics();
    MetalStatistics joined(const Parts& parts) const;

    gl::ShaderLibrary& shaders_;
    PhysicalSetup setup_;
    float timeStep_;
    HeatTable table_;
    const gl::Program& count_;
    gl::Buffer parts_;
    gl::ReadbackQueue answers_;
    std::unique_ptr<MetalState> state_;
    std::unique_ptr<HeatSolver> heat_;
    std::unique_ptr<Flow> flow_;
    std::unique_ptr<RigidFragments> fragments_;
    size_t room_ = 0;                 ///< particles that all buffers have room for
    bool grows_ = true;               ///< false: the driver had no room for more
    std::vector<MetalSeed> accepted_; ///< kept so that filler costs no allocation
    size_t refused_ = 0;
};

} // namespace meltpool
