// The volumes of the surface: sums at the grid's corners over the particles around.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/program.hpp"
#include "core/metal/state/particle_view.hpp"
#include "core/surface/splat_passes.hpp"
#include "core/surface/surface_grid.hpp"

#include <optional>

namespace meltpool {

/// Volumes of density and temperature of particles; for particles that store them, also of their highest temperatures
/// and freezing times (see Surface). Notes the blocks whose corners change, for the mesher. The passes read the setup,
/// which must be bound.
class SurfaceVolumes {
  public:
    /// `commands` (SurfaceCommands) must outlive this object; it holds the numbers of particles to splat.
    SurfaceVolumes(gl::ShaderLibrary& shaders, const SurfaceGrid& grid, const gl::Buffer& commands);

    /// Makes the buffers large enough that store `particles` as splatted, for incremental updates. New ones are empty:
    /// the volumes must be filled again.
    void growParticleBuffers(size_t particles);
    /// Makes the next update fill the volumes again.
    void forget() { splattedCount_ = 0; }
    /// Returns true if the volumes hold particles of this kind, and no more of them: splatChanged() suffices.
    bool canFollow(const ParticleView& particles) const;
    /// Takes these particles as those of the update and makes the volumes that they need. `remembered`: the next update
    /// can follow them.
    void take(const ParticleView& particles, bool remembered);

    /// Empties the volumes and marks every particle as not splatted.
    void clear();
    /// Adds all particles to empty volumes. `kernel`: a SurfaceKernel.
    void splatAll(const ParticleView& particles, int kernel);
    /// Moves the particles that changed since they were splatted.
    void splatChanged(const ParticleView& particles, int kernel);

    int particleData() const { return data_; } ///< bits SURFACE_WITH_* of the particles
    const gl::Buffer& density() const { return density_; }
    const gl::Buffer& temperature() const { return temperature_; }
    const gl::Buffer* freezing() const; ///< null if the last particles had no freezing times
    const gl::Buffer& blockFlags() const { return blockFlags_; }

    void bindDensityTexels() const { densityTexels_.bind(SURFACE_TEXELS_DENSITY); }
    void bindTemperatureTexels() const { temperatureTexels_.bind(SURFACE_TEXELS_TEMPERATURE); }
    void bindPeakTexels() const;     ///< no-op if no particles had highest temperatures so far
    void bindFreezingTexels() const; ///< no-op if the last particles had no freezing times

    size_t bytes() const; ///< bytes of GPU memory

  private:
    /// Highest temperature so far: a third volume, for particles that store it.
    struct Peaks {
        gl::Buffer volume, splatted; // a word a corner, a particle
        gl::BufferView volumeTexels, heatTexels;
    };
    /// Freezing times of the metal: a volume of two words a corner.
    struct Freezing {
        gl::Buffer volume, splatted; // two words a corner, one a particle
        gl::BufferView volumeTexels, particleTexels, splattedTexels;
    };

    bool withFreezing() const { return (data_ & SURFACE_WITH_FREEZING) != 0; }
    void makePeaks();
    void makeFreezing();
    void bindParticles(const ParticleView& particles);
    void bindPeaks(const ParticleView& particles);
    void bindFreezing(const ParticleView& particles);
    void bindLattice(const ParticleView& particles);

    const gl::Buffer& commands_;
    size_t splattedCount_ = 0; ///< particles in the volumes; 0: the next update rebuilds
    int data_ = 0;
    SplatPassLibrary splatters_;
    gl::Buffer splatted_, changedList_; // a vec4 and a uint a particle
    gl::Buffer density_, temperature_;
    gl::BufferView densityTexels_, temperatureTexels_;
    gl::Buffer blockFlags_;
    gl::BufferView particleTexels_, splattedTexels_, latticeTexels_, numberTexels_;
    std::optional<Peaks> peaks_;
    std::optional<Freezing> freezing_;
};

} // namespace meltpool
