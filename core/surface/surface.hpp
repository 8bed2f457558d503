// Turns particles into a closed triangle mesh on the GPU: density and temperature volumes, then marching cubes.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/metal/particle_view.hpp"
#include "core/surface/surface_mesh.hpp"
#include "core/surface/surface_parameters.hpp"

#include <memory>

namespace meltpool {

/// Small results of an update, read back without waiting.
struct SurfaceStatistics {
    unsigned vertices = 0;
    unsigned triangles = 0;
    unsigned blocks = 0;   ///< blocks of 8³ cells that the metal reaches
    bool overflow = false; ///< the mesh did not fit its buffers; what is drawn is a part of it
};

class Surface {
  public:
    /// Lays a grid over the box: `parameters.cells` along its longest side, cells as near to cubes as whole numbers
    /// allow along the others. Throws InputError when the box is empty or the parameters are out of range.
    Surface(gl::ShaderLibrary& shaders, const SurfaceParameters& parameters, glm::vec3 boxMin, glm::vec3 boxMax);
    ~Surface();
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    /// Live values; `cells` is only read at construction.
    SurfaceParameters parameters;

    /// The particles' temperatures that the volume resolves; beyond it they are clamped. Classic: 0..1 (the default).
    void setTemperatureRange(float coldest, float hottest);

    /// Makes the mesh of these particles; nothing is read back. Passes are timed below the scope "surface".
    void update(const ParticleView& particles, gl::Profiler* profiler);

    SurfaceMesh mesh() const;

    /// GPU memory that this surface holds.
    size_t bytes() const;

    /// Counts of the last update. statistics() waits for the GPU; poll never does: request, then ask in later frames.
    SurfaceStatistics statistics() const;
    void requestStatistics();
    std::optional<SurfaceStatistics> pollStatistics();

  private:
    struct Work;
    std::unique_ptr<Work> work_;
};

} // namespace meltpool
