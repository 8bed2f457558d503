#include "core/surface/surface_volumes.hpp"

#include "core/metal/state/metal_state.hpp"
#include "core/surface/surface_barrier.hpp"

#include <bit>
#include <cstddef>

namespace meltpool {

namespace {

int dataOf(const ParticleView& particles) {
    return (particles.phases != nullptr ? SURFACE_WITH_PHASES : 0) |
           (particles.heats != nullptr ? SURFACE_WITH_PEAKS : 0) |
           (particles.frozenAt != nullptr ? SURFACE_WITH_FREEZING : 0) |
           (particles.numbers != nullptr ? SURFACE_WITH_NUMBERS : 0);
}

} // namespace

SurfaceVolumes::SurfaceVolumes(gl::ShaderLibrary& shaders, const SurfaceGrid& grid, const gl::Buffer& commands)
    : commands_(commands),
      splatters_(shaders),
      density_("surface density", grid.blockCount() * SURFACE_BLOCK_CORNERS * 4),
      temperature_("surface temperature", grid.blockCount() * SURFACE_BLOCK_CORNERS * 4),
      densityTexels_("surface density", density_, GL_R32UI, 4),
      temperatureTexels_("surface temperature", temperature_, GL_R32UI, 4),
      blockFlags_("surface block flags", grid.blockCount() * 4) {}

void SurfaceVolumes::growParticleBuffers(size_t particles) {
    if (splatted_ && splatted_.bytes() >= particles * sizeof(glm::vec4)) return;
    // Filler adds a particle in every frame: without spare room every frame would rebuild.
    if (splatted_) particles += particles / 8 + 1024;
    splatted_ = gl::Buffer("surface splatted particles", particles * sizeof(glm::vec4));
    changedList_ = gl::Buffer("surface changed particles", particles * 4);
    splattedTexels_ = gl::BufferView("surface splatted particles", splatted_, GL_RGBA32F, sizeof(glm::vec4));
    splattedCount_ = 0;
}

bool SurfaceVolumes::canFollow(const ParticleView& particles) const {
    return splattedCount_ != 0 && particles.count >= splattedCount_ && data_ == dataOf(particles);
}

void SurfaceVolumes::take(const ParticleView& particles, bool remembered) {
    splattedCount_ = remembered ? particles.count : 0;
    data_ = dataOf(particles);
    if (particles.heats != nullptr) makePeaks();
    if (withFreezing()) makeFreezing();
}

void SurfaceVolumes::makePeaks() {
    if (!peaks_) {
        peaks_.emplace();
        peaks_->volume = gl::Buffer("surface peaks", density_.bytes());
        peaks_->volumeTexels = gl::BufferView("surface peaks", peaks_->volume, GL_R32UI, 4);
    }
    const size_t bytes = splatted_ ? splatted_.bytes() / 4 : 4; // a float a particle instead of a vec4
    if (peaks_->splatted.bytes() < bytes) peaks_->splatted = gl::Buffer("surface splatted peaks", bytes);
}

void SurfaceVolumes::makeFreezing() {
    if (!freezing_) {
        freezing_.emplace();
        freezing_->volume = gl::Buffer("surface freezing", 2 * density_.bytes());
        freezing_->volumeTexels = gl::BufferView("surface freezing", freezing_->volume, GL_RG32UI, 8);
    }
    const size_t bytes = splatted_ ? splatted_.bytes() / 4 : 4; // a float a particle instead of a vec4
    if (freezing_->splatted.bytes() >= bytes) return;
    freezing_->splatted = gl::Buffer("surface splatted freezing times", bytes);
    freezing_->splattedTexels = gl::BufferView("surface splatted freezing times", freezing_->splatted, GL_R32F, 4);
}

void SurfaceVolumes::clear() {
    density_.clear();
    temperature_.clear();
    if (peaks_) peaks_->volume.clear();
    if (withFreezing()) freezing_->volume.clear();
    if (splatted_) splatted_.fill(std::bit_cast<GLuint>(SURFACE_NOWHERE));
    surfaceBarrier();
}

void SurfaceVolumes::bindParticles(const ParticleView& particles) {
    // A new view for each update: another buffer of particles may have an equal GL name.
    particleTexels_ = gl::BufferView("surface particles", *particles.positions, GL_RGBA32F, sizeof(glm::vec4));
    particleTexels_.bind(SURFACE_TEXELS_PARTICLES);
    // Passes that do not read phases or splatted particles still need a buffer bound there.
    (particles.phases != nullptr ? *particles.phases : commands_).bindStorage(SURFACE_BIND_PHASES);
    (splatted_ ? splatted_ : commands_).bindStorage(SURFACE_BIND_SPLATTED);
    (changedList_ ? changedList_ : commands_).bindStorage(SURFACE_BIND_CHANGED_LIST);
    density_.bindStorage(SURFACE_BIND_DENSITY);
    temperature_.bindStorage(SURFACE_BIND_TEMPERATURE);
    blockFlags_.bindStorage(SURFACE_BIND_BLOCK_FLAGS);
    commands_.bindStorage(SURFACE_BIND_COMMANDS);
    bindPeaks(particles);
    if (withFreezing()) bindFreezing(particles);
    bindLattice(particles);
    if (particles.numbers == nullptr) return;
    numberTexels_ = gl::BufferView("surface numbers", *particles.numbers, GL_R32UI, sizeof(unsigned));
    numberTexels_.bind(SURFACE_TEXELS_NUMBERS);
}

void SurfaceVolumes::bindPeaks(const ParticleView& particles) {
    (peaks_ ? peaks_->volume : commands_).bindStorage(SURFACE_BIND_PEAK);
    (peaks_ ? peaks_->splatted : commands_).bindStorage(SURFACE_BIND_SPLATTED_PEAKS);
    if (particles.heats == nullptr) return;
    peaks_->heatTexels = gl::BufferView("surface heats", *particles.heats, GL_RGBA32F, sizeof(glm::vec4));
    peaks_->heatTexels.bind(SURFACE_TEXELS_HEATS);
}

void SurfaceVolumes::bindFreezing(const ParticleView& particles) {
    freezing_->volume.bindStorage(SURFACE_BIND_FREEZING);
    freezing_->splatted.bindStorage(SURFACE_BIND_SPLATTED_FREEZING);
    freezing_->particleTexels = gl::BufferView("surface freezing times", *particles.frozenAt, GL_R32F, sizeof(float));
    freezing_->particleTexels.bind(SURFACE_TEXELS_FROZEN_AT);
}

/// Binds the lattice, which the mesher's passes read: it stays bound, as positions, heats and freezing times do.
void SurfaceVolumes::bindLattice(const ParticleView& particles) {
    if (particles.lattice == nullptr) return;
    latticeTexels_ = gl::BufferView("surface lattice", *particles.latticeSlots, GL_R32UI, 4);
    latticeTexels_.bind(SURFACE_TEXELS_LATTICE);
}

void SurfaceVolumes::splatAll(const ParticleView& particles, int kernel) {
    bindParticles(particles);
    splatters_.passes(data_, kernel).splatAll.dispatch(particles.count, SURFACE_GROUP);
    surfaceBarrier();
}

void SurfaceVolumes::splatChanged(const ParticleView& particles, int kernel) {
    bindParticles(particles);
    splattedTexels_.bind(SURFACE_TEXELS_SPLATTED);
    if (withFreezing()) freezing_->splattedTexels.bind(SURFACE_TEXELS_FREEZING);
    const SplatPasses& passes = splatters_.passes(data_, kernel);
    passes.compare.dispatch(particles.count, SURFACE_GROUP);
    surfaceCommandBarrier();
    passes.splatChanged.dispatchIndirect(offsetof(SurfaceCommands, changed));
    surfaceBarrier();
}

const gl::Buffer* SurfaceVolumes::freezing() const {
    return withFreezing() ? &freezing_->volume : nullptr;
}

void SurfaceVolumes::bindPeakTexels() const {
    if (peaks_) peaks_->volumeTexels.bind(SURFACE_TEXELS_PEAK);
}

void SurfaceVolumes::bindFreezingTexels() const {
    if (withFreezing()) freezing_->volumeTexels.bind(SURFACE_TEXELS_FREEZING);
}

size_t SurfaceVolumes::bytes() const {
    size_t sum =
        splatted_.bytes() + changedList_.bytes() + density_.bytes() + temperature_.bytes() + blockFlags_.bytes();
    if (peaks_) sum += peaks_->volume.bytes() + peaks_->splatted.bytes();
    if (freezing_) sum += freezing_->volume.bytes() + freezing_->splatted.bytes();
    return sum;
}

} // namespace meltpool
