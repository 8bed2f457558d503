// Islands of oxide that float on a pool: the choice of liquid particles that carry one. An island drifts with its
// particles, and with nothing else.
#pragma once

#include "core/gl/program.hpp"
#include "core/metal/state/particle_view.hpp"

namespace meltpool {

class FloatingOxide {
  public:
    explicit FloatingOxide(gl::ShaderLibrary& shaders);

    /// Finds the carriers among particles with temperatures in kelvin. Expects the frame's uniform block bound, and
    /// leaves the list at its binding (OXIDE_BINDING, shaders/shared/render.h) for the draws to come.
    void find(const ParticleView& particles);

  private:
    const gl::Program& find_;
    gl::Buffer islands_;
};

} // namespace meltpool
