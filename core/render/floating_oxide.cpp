#include "core/render/floating_oxide.hpp"

#include "shaders/shared/render.h"

namespace meltpool {

FloatingOxide::FloatingOxide(gl::ShaderLibrary& shaders)
    : find_(shaders.compute("render/find_oxide.comp")), islands_("floating oxide", sizeof(OxideIslands)) {}

void FloatingOxide::find(const ParticleView& particles) {
    find_.use();
    find_.set("particleCount", static_cast<unsigned>(particles.count));
    particles.positions->bindStorage(OXIDE_PARTICLES_BINDING);
    islands_.bindStorage(OXIDE_BINDING);
    find_.dispatchGroups(1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

} // namespace meltpool
