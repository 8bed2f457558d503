// The flow of molten metal: soft weakly compressible SPH with surface tension on the GPU, moving liquid only.
#pragma once

#include "core/gl/buffer_view.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/metal/flow/arc_pressure.hpp"
#include "core/metal/flow/flow_capacity.hpp"
#include "core/metal/flow/flow_constants.hpp"
#include "core/metal/flow/flow_tables.hpp"

namespace meltpool {

/// The space that metal may move in. Metal stops at its ends.
struct FlowSpace {
    glm::vec3 low{0};          ///< m
    glm::vec3 high{0};         ///< m
    glm::bvec3 repeats{false}; ///< axes along which space repeats; at least three supports long
    glm::vec3 acceleration{0}; ///< body force over density besides gravity, m/s²
};

/// Faults since the start; all zero in a healthy run.
struct FlowFaults {
    unsigned cellsOverfull = 0, neighboursOverfull = 0, notFinite = 0, listsOverfull = 0;
    bool any() const { return (cellsOverfull | neighboursOverfull | notFinite | listsOverfull) != 0; }
};

/// Moves the liquid particles of a MetalState. Solid metal bounds them with its own density and pressure (Akinci et al.
/// 2012). A substep touches only the moving metal and adjacent wall metal.
class Flow {
  public:
    /// `state` must outlive the flow. Throws RuntimeFault if `space` repeats after less than three supports.
    Flow(gl::ShaderLibrary& shaders, MetalState& state, const FlowFluid& fluid, const FlowSpace& space);

    /// Returns to the initial state without allocating; call it after the state was reset and refilled.
    void reset();
    /// Adapts to the state's new capacity. Waits for the GPU. Throws RuntimeFault if the driver has no memory.
    void onCapacityChanged();

    /// Moves all liquid on by `seconds` in as many equal substeps as stability needs. First finds the slots that
    /// melted, froze or are new.
    void step(double seconds, gl::Profiler* profiler);
    /// Moves all liquid on with a given number of substeps.
    void step(double seconds, unsigned substeps, gl::Profiler* profiler);

    /// Saves or restores all that the next step reads; transfer the state first. Waits for the GPU when restoring.
    void transfer(gl::StateArchive& archive);
    /// Applies PhysicalMetal::xorOutDerivedState() to the flow's copies of places and velocities.
    void xorOutDerivedState();

    void setAcceleration(glm::vec3 acceleration); ///< body force over density besides gravity, m/s²

    void setArc(const ArcPressure& arc);
    /// Takes over the liquid's wetting of cold and warm wall metal from the next step on.
    void setWetting(const FlowFluid& fluid);

    const FlowConstants& constants() const { return constants_; }
    FlowFaults readFaults() const; ///< waits for the GPU
    unsigned readMoving() const;   ///< moving particles; waits for the GPU
    unsigned readSearches() const; ///< neighbour searches since the start; waits for the GPU
    /// Particles at the last substep's start; density 0 if it was never computed. Waits for the GPU.
    std::vector<FlowParticle> readParticles() const;
    size_t bytes() const;

  private:
    void growLists(bool waits);
    void takeSavedRoom();
    void makeTexels();
    void moveLists(size_t before);
    void bind();
    void updateGroups(gl::Profiler* profiler);
    void substep(gl::Profiler* profiler);

    MetalState& state_;
    FlowConstants constants_;
    double restDensity_;
    FlowBlock block_{};
    const FlowBlock first_; ///< the initial values
    bool blockChanged_ = true;
    size_t known_ = 0;         ///< classified slots
    unsigned regroupings_ = 0; ///< the state's number when all slots were last classified
    const gl::Program& classify_;
    const gl::Program& compact_;
    const gl::Program& bin_;
    const gl::Program& sort_;
    const gl::Program& search_;
    const gl::Program& boundary_;
    const gl::Program& density_;
    const gl::Program& move_;
    const gl::Program& xorOutDerived_;
    FlowCapacity capacity_;
    FlowTables tables_;
    gl::Buffer blockBuffer_, particles_, cells_, nextInCell_, lists_, counters_, changed_, wallSums_;
    gl::BufferView positionTexels_, particleTexels_, cellTexels_;
};

} // namespace meltpool
