// The flow of molten metal: soft weakly compressible SPH with surface tension on the GPU, moving liquid only.
#pragma once

#include "core/gl/buffer_view.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/metal/flow/flow_constants.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/flow.h"

namespace meltpool {

/// The space that metal may move in. Beyond it nothing goes: metal stops at its ends.
struct FlowSpace {
    glm::vec3 low{0};          ///< m
    glm::vec3 high{0};         ///< m
    glm::bvec3 repeats{false}; ///< axes along which space repeats; at least three supports long
    glm::vec3 acceleration{0}; ///< body force over density besides gravity, m/s²
};

/// Pressure of an arc on the surface that faces it: peak exp(-r²/(2 sigma²)) around its axis.
struct ArcPressure {
    glm::vec3 place{0};       ///< m, on the axis
    glm::vec3 axis{0, -1, 0}; ///< unit vector into the metal
    float sigma = 2e-3F;      ///< m
    float peak = 0;           ///< Pa
};

/// How many went wrong so far; all zero in a healthy run.
struct FlowFaults {
    unsigned cellsOverfull = 0, neighboursOverfull = 0, notFinite = 0, listOverfull = 0;
    bool any() const { return (cellsOverfull | neighboursOverfull | notFinite | listOverfull) != 0; }
};

/// Moves the liquid particles of a MetalState. Still metal (solid, of no loose piece) is their boundary, with its own
/// density and pressure. Work follows the liquid: only it and the still metal beside it are touched in a substep.
class Flow {
  public:
    /// `movingRoom`: most particles that move or lie beside moving ones at a time; 0 makes room for all.
    Flow(gl::ShaderLibrary& shaders, MetalState& state, const FlowFluid& fluid, const FlowSpace& space,
         size_t movingRoom = 0);

    /// Moves all liquid on by `seconds` in as many equal substeps as stability needs. First takes up which slots
    /// melted, froze or are new.
    void step(double seconds, gl::Profiler* profiler);
    /// The same with a given number of substeps.
    void step(double seconds, unsigned substeps, gl::Profiler* profiler);

    void setAcceleration(glm::vec3 acceleration); ///< body force over density besides gravity, m/s²

    void setArc(const ArcPressure& arc);

    const FlowConstants& constants() const { return constants_; }
    FlowFaults readFaults() const; ///< waits for the GPU
    unsigned readMoving() const;   ///< moving particles; waits for the GPU
    unsigned readSearches() const; ///< times that neighbour lists were made; waits for the GPU
    /// Density ratio delta of each slot as of the last substep's start; 0 where never computed. Waits for the GPU.
    std::vector<FlowBody> readBodies() const;
    size_t bytes() const;

  private:
    void bind() const;
    void takeUpChanges(gl::Profiler* profiler);
    void substep(gl::Profiler* profiler);

    MetalState& state_;
    FlowConstants constants_;
    double restDensity_;
    FlowBlock block_{};
    bool blockChanged_ = true;
    uint substep_ = 0;
    uint frame_ = 0;
    size_t known_ = 0;         ///< slots that the flow has looked at
    unsigned regroupings_ = 0; ///< of the state when it last looked at all of them
    const gl::Program& belong_;
    const gl::Program& tidy_;
    const gl::Program& enter_;
    const gl::Program& sort_;
    const gl::Program& search_;
    const gl::Program& boundary_;
    const gl::Program& density_;
    const gl::Program& move_;
    gl::Buffer blockBuffer_, bodies_, cells_, residents_, entered_, lists_, neighbours_, counters_, dirty_, resting_;
    gl::BufferView positionTexels_, bodyTexels_, neighbourTexels_, cellTexels_, residentTexels_, residentPlaceTexels_;
};

} // namespace meltpool
