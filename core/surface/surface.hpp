// Turns particles into a closed triangle mesh on the GPU: density and temperature volumes, then marching cubes.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/metal/state/particle_view.hpp"
#include "core/surface/surface_grid.hpp"
#include "core/surface/surface_mesh.hpp"
#include "core/surface/surface_parameters.hpp"

#include <memory>
#include <optional>

namespace meltpool {

/// Small results of an update.
struct SurfaceStatistics {
    unsigned vertices = 0;
    unsigned triangles = 0; ///< with those that were made empty since the last whole mesh
    unsigned blocks = 0;    ///< blocks of 8³ cells that were made anew
    unsigned particles = 0; ///< particles that were entered anew
    bool whole = true;      ///< every block was made anew
    bool overflow = false;  ///< the mesh did not fit its buffers; what is drawn is a part of it
};

/// How an update uses what earlier ones made. Off, every update starts from nothing.
struct SurfaceKeeping {
    /// Only particles that changed are entered anew and only blocks around them are made anew: the cost follows what
    /// moves or warms, not the metal. For particles that keep their slots.
    bool on = false;
    float stillCells = 0;       ///< a particle stays as it was entered until it is farther than this from there
    float stillTemperature = 0; ///< ... and its temperature by this share of the temperature range
};

/// The density volume holds at every corner of the grid the sum of the weights 1 - d / d_max of the particles around, d
/// in cells, d_max = sqrt(3) / 2 + sqrt(3) (influence - 1), as integers of 1/10000. The temperature volume holds the
/// sum of weight x temperature; the surface's temperature is the quotient of the two, the weighted mean, so that it
/// does not depend on how densely the particles lie. Both are sums of integers: the same particles give the same bits
/// in any order.
///
/// Particles that remember their highest temperature give a third volume, and the mesh its peaks, in the same way.
///
/// The smooth kernel has other weights (SurfaceKernel).
///
/// Triangles and vertices are ordered by block of 8³ cells, then row, then cell. With SurfaceKeeping the blocks that
/// changed since the whole mesh was last made follow behind the others, and the triangles they had before are empty
/// (three times vertex 0); the mesh is whole again when a third of it has changed. That happens on the GPU and depends
/// on nothing but the particles: the same updates give the same bits.
class Surface {
  public:
    /// Lays a grid over the box: `parameters.cells` along its longest side, cells as near to cubes as whole numbers
    /// allow along the others. Throws InputError when the box is empty or the cells are out of range.
    Surface(gl::ShaderLibrary& shaders, const SurfaceParameters& parameters, glm::vec3 boxMin, glm::vec3 boxMax);
    ~Surface();
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    /// Live values; `cells` is only read at construction.
    SurfaceParameters parameters;
    SurfaceKeeping keeping;

    /// The particles' temperatures that the volume resolves; beyond it they are clamped. Classic: 0..1 (the default).
    void setTemperatureRange(float coldest, float hottest);

    /// Makes the mesh of these particles; nothing is read back. Passes are timed below the scope "surface".
    void update(const ParticleView& particles, gl::Profiler* profiler);

    SurfaceMesh mesh() const;
    const SurfaceGrid& grid() const;

    /// The volumes' sums by SurfaceGrid::address(), as 32-bit unsigned integers.
    const gl::Buffer& densityVolume() const;
    const gl::Buffer& temperatureVolume() const;
    /// Binds setup and both volumes to their places (shaders/shared/surface.h), for passes that look at them.
    void bindVolumes() const;

    /// GPU memory that this surface holds.
    size_t bytes() const;

    /// Counts of the last update; waits for the GPU.
    SurfaceStatistics statistics() const;
    /// The same without waiting: request them after an update, then ask in later frames until they are there.
    void requestStatistics();
    std::optional<SurfaceStatistics> pollStatistics();

  private:
    bool mustStartAnew(const ParticleView& particles) const;

    struct Work;
    std::unique_ptr<Work> work_;
};

} // namespace meltpool
