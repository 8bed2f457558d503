// The classic model: melting particles of one substance, stepped on the GPU.
#pragma once

#include "core/gl/buffer_view.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/metal/classic/cell_order.hpp"
#include "core/metal/classic/classic_parameters.hpp"
#include "core/metal/classic/statistics_reader.hpp"
#include "core/metal/state/particle_view.hpp"
#include "core/metal/state/statistics.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace meltpool {

/// What heats, or with `cold` freezes, the metal.
struct ClassicSource {
    glm::vec3 position{0.9F}; ///< box units
    float strength = 0;       ///< 0 off .. 1 fully on
    bool cold = false;        ///< takes the temperature away instead of giving it
};

class ClassicMetal {
  public:
    /// Throws InputError for a setup without particles, RuntimeFault when the GPU has no room.
    ClassicMetal(gl::ShaderLibrary& library, const ClassicSetup& setup);

    /// May be changed between any two steps.
    ClassicParameters parameters;

    /// Puts every particle back where it started, solid and at rest. The parameters stay.
    void reset();

    /// One time step. `profiler` may be null.
    void step(const ClassicSource& source, gl::Profiler* profiler);

    /// The places and temperatures after the last step, valid as long as this object. The order of the particles
    /// changes from step to step.
    ParticleView particles() const { return {&movedPositions_, count_}; }

    /// Counts and temperatures of this moment; waits for the GPU.
    MetalStatistics statistics() const;
    /// Asks for them without waiting; a request made while all slots are on their way is dropped.
    void requestStatistics();
    /// The newest that have arrived since the last call, else nothing; never waits.
    std::optional<MetalStatistics> pollStatistics() { return reader_.poll(); }

    /// Of position, velocity and temperature of every particle by number, bit by bit; waits for the GPU.
    std::uint64_t stateHash() const;

    /// GPU memory in all.
    size_t bytes() const;

    /// The thesis's loop over all pairs instead of the grid: slow, kept to check the grid against.
    void useAllPairs(bool allPairs) { allPairs_ = allPairs; }

    /// Everything about every particle by number, for tests and records; waits for the GPU.
    struct Snapshot {
        std::vector<glm::vec4> positions;  ///< w = temperature
        std::vector<glm::vec4> velocities; ///< w = density in the last step
    };
    Snapshot snapshot() const;
    /// Takes over such a state; both lists have a row for each particle.
    void restore(const Snapshot& state);

  private:
    void writeStep(const ClassicSource& source);
    void bindState() const;
    void sortByCell(gl::Profiler* profiler);
    void keepOrder();
    void computeDensity(gl::Profiler* profiler);
    void moveParticles(gl::Profiler* profiler);

    ClassicSetup setup_;
    size_t count_;
    bool allPairs_ = false;
    gl::Buffer stepBlock_;
    gl::Buffer movedPositions_, movedVelocities_, movedNumbers_;
    gl::Buffer sortedPositions_, sortedVelocities_, sortedNumbers_;
    gl::Buffer refused_;                             // one uint: new states since the reset that were no numbers
    gl::BufferView positionTexels_, velocityTexels_; // of the sorted state
    CellOrder order_;
    StatisticsReader reader_;
    struct Passes {
        const gl::Program& density;
        const gl::Program& move;
    };
    Passes grid_, pairs_;
};

} // namespace meltpool
