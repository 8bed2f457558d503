// The classic model of the founding thesis: melting SPH particles of one substance, stepped on the GPU.
#pragma once

#include "core/gl/buffer_view.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/gl/state_archive.hpp"
#include "core/metal/classic/cell_order.hpp"
#include "core/metal/classic/classic_parameters.hpp"
#include "core/metal/classic/statistics_reader.hpp"
#include "core/metal/state/particle_view.hpp"
#include "core/metal/state/statistics.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace meltpool {

/// The source that heats or cools the metal.
struct ClassicSource {
    glm::vec3 position{0.9F}; ///< box units
    float strength = 0;       ///< 0 off .. 1 fully on
    bool cold = false;        ///< cools instead of heating
};

class ClassicMetal {
  public:
    /// Throws InputError for a setup without particles, RuntimeFault if the GPU has no memory.
    ClassicMetal(gl::ShaderLibrary& library, const ClassicSetup& setup);

    /// Changes between steps are allowed.
    ClassicParameters parameters;

    /// Returns every particle to its start, solid and at rest. The parameters stay.
    void reset();

    /// Makes one time step. `profiler` may be null.
    void step(const ClassicSource& source, gl::Profiler* profiler);

    /// Positions and temperatures after the last step, valid for this object's lifetime. The order of the particles
    /// changes from step to step, their numbers do not.
    ParticleView particles() const {
        return {.positions = &movedPositions_, .count = count_, .numbers = &movedNumbers_};
    }

    /// Present counts and temperatures; waits for the GPU.
    MetalStatistics statistics() const;
    /// Requests statistics without waiting; dropped while all slots are pending.
    void requestStatistics();
    /// The newest statistics that arrived since the last call, or nothing; never waits.
    std::optional<MetalStatistics> pollStatistics() { return reader_.poll(); }
    /// The requested statistics; waits for the GPU.
    std::optional<MetalStatistics> awaitStatistics() { return reader_.await(); }

    /// Hash of the bits of position, temperature and velocity of every particle, in the order of their numbers; waits
    /// for the GPU.
    std::uint64_t stateHash() const;

    /// Bytes of GPU memory in use.
    size_t bytes() const;

    /// Loops over all pairs, as in the thesis, instead of the grid: slow; tests compare the grid with it.
    void useAllPairs(bool allPairs) { allPairs_ = allPairs; }

    /// State of every particle in the order of their numbers, for tests and recordings; waits for the GPU.
    struct Snapshot {
        std::vector<glm::vec4> positions;  ///< positions with temperature
        std::vector<glm::vec4> velocities; ///< velocities with density in the last step
    };
    Snapshot snapshot() const;
    /// Saves or restores all that the next step reads except the parameters. Restoring discards pending answers.
    void transfer(gl::StateArchive& archive);
    /// Sets a state. Throws RuntimeFault unless both lists have an entry a particle.
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
    gl::Buffer refused_; // one uint: states since the reset that were not finite and were not stored
    gl::BufferView positionTexels_, velocityTexels_; // views of the sorted state
    CellOrder order_;
    StatisticsReader reader_;
    struct Passes {
        const gl::Program& density;
        const gl::Program& move;
    };
    Passes grid_, pairs_;
};

} // namespace meltpool
