// Conversion of particles to a closed triangle mesh on the GPU: density and temperature volumes, then marching cubes.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/metal/state/particle_view.hpp"
#include "core/surface/surface_grid.hpp"
#include "core/surface/surface_mesh.hpp"
#include "core/surface/surface_parameters.hpp"

#include <array>
#include <memory>
#include <optional>

namespace meltpool {

/// Small results of an update.
struct SurfaceStatistics {
    unsigned vertices = 0;
    unsigned triangles = 0; ///< triangles, including those emptied since the last rebuild
    unsigned blocks = 0;    ///< blocks of 8³ cells that this update meshed
    unsigned particles = 0; ///< particles that this update splatted
    bool rebuilt = true;    ///< true if the whole mesh was made
    bool overflow = false;  ///< true if the mesh did not fit its buffers and is incomplete
};

/// Settings of incremental updates. Without them every update rebuilds volumes and mesh.
struct IncrementalUpdate {
    /// Splat only particles that changed and mesh only the blocks around them: the cost depends on the number of
    /// particles that move or change temperature, not on the number of all. Particles must keep their slots or have
    /// numbers.
    bool enabled = false;
    float positionTolerance = 0;    ///< a particle counts as unchanged until it moved farther than this, cells
    float temperatureTolerance = 0; ///< ... or until its temperature changed by more than this share of the range
};

/// Flat faces of a workpiece, in model units: each corner gives a plane across every axis.
struct FlatFaces {
    std::array<glm::vec3, SURFACE_FLAT_PLANES> corners{};
    int count = 0;
};

/// A pipe along z whose faces are round and whose ends are flat, in model units. `outer` is 0 if there is none.
struct RoundFaces {
    glm::vec2 axis{0}; ///< x and y
    float low = 0, high = 0;
    float outer = 0, inner = 0; ///< radii
};

/// The metal's surface, made from particles.
///
/// The density volume holds at every corner of the grid the sum of the weights 1 - d / d_max of the particles around, d
/// in cells, d_max = sqrt(3) / 2 + sqrt(3) (influence - 1), as integers of 1/10000. The temperature volume holds the
/// sum of weight x temperature; the surface's temperature is the quotient of the two, the weighted mean, so that it
/// does not depend on the density of the particles. Both are sums of integers: a set of particles gives identical bits
/// in any order.
///
/// Particles that store their highest temperature fill a third volume, from which the mesh gets its peaks likewise.
///
/// Particles that store when they froze fill a volume of their own: sums of weights and of weight x time over the metal
/// that froze alone, so that a neighbour that never melted does not count. The mesh gets from it the time and its
/// gradient (SurfaceFreezing), and the share of frozen metal. With them vertices next to metal that is still on its
/// lattice are moved onto the lattice's own surface if that is in FlatFaces: flat, with edges; and onto those of
/// RoundFaces. The volumes do not change. Metal that froze after SURFACE_FREEZING_LONGEST does not count.
///
/// The smooth kernel has other weights (SurfaceKernel).
///
/// Triangles and vertices are ordered by block of 8³ cells, then row, then cell. After incremental updates the blocks
/// that changed since the last rebuild follow behind the others, and their former triangles are empty (three times
/// vertex 0). The mesh is rebuilt when a third of its blocks changed. The GPU decides that from the particles alone:
/// identical updates give identical bits.
class Surface {
  public:
    /// Divides the box into a grid: `parameters.cells` along its longest side, along the others as many as make the
    /// cells most nearly cubes. Throws InputError when the box is empty or the cells are out of range.
    Surface(gl::ShaderLibrary& shaders, const SurfaceParameters& parameters, glm::vec3 boxMin, glm::vec3 boxMax);
    ~Surface();
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    /// Live values; `cells` is only read at construction.
    SurfaceParameters parameters;
    IncrementalUpdate incremental;
    /// Faces that are used if the particles have a lattice and store their highest temperatures or freezing times.
    FlatFaces flatFaces;
    RoundFaces roundFaces;

    /// Sets the range of temperatures that the volume stores; others are clamped to it. The default, 0..1, is the
    /// classic model's. Throws InputError when the range is empty.
    void setTemperatureRange(float coldest, float hottest);

    /// Makes the mesh of these particles without reading anything back. The passes are timed below the scope "surface".
    void update(const ParticleView& particles, gl::Profiler* profiler);

    SurfaceMesh mesh() const;
    const SurfaceGrid& grid() const;

    /// Returns the volumes, indexed by SurfaceGrid::address(): 32-bit unsigned integers.
    const gl::Buffer& densityVolume() const;
    const gl::Buffer& temperatureVolume() const;
    /// Returns two integers a corner, sums of weights and of weight x ticks; null if the last particles had no freezing
    /// times.
    const gl::Buffer* freezingVolume() const;
    /// Binds setup and both volumes to their binding points (shaders/shared/surface.h), for passes that read them.
    void bindVolumes() const;

    /// Returns the bytes of GPU memory in use.
    size_t bytes() const;

    /// Returns the counts of the last update; waits for the GPU.
    SurfaceStatistics statistics() const;
    /// Requests the counts without waiting: call it after an update, then poll in later frames until they have arrived.
    void requestStatistics();
    std::optional<SurfaceStatistics> pollStatistics();

  private:
    bool mustRebuild(const ParticleView& particles) const;
    void writeSetup(const ParticleView& particles, bool rebuild);

    struct Work;
    std::unique_ptr<Work> work_;
};

} // namespace meltpool
