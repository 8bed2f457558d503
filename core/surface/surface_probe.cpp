#include "core/surface/surface_probe.hpp"

namespace meltpool {

namespace {

SurfaceSounding soundingOf(const SurfaceProbeAnswer& answer) {
    return {answer.found.x, answer.found.y, answer.found.z, glm::vec3(answer.normal)};
}

} // namespace

SurfaceProbe::SurfaceProbe(gl::ShaderLibrary& shaders)
    : program_(shaders.compute("surface/probe.comp")),
      answer_("surface probe", sizeof(SurfaceProbeAnswer)),
      readback_("surface probe", sizeof(SurfaceProbeAnswer)) {}

void SurfaceProbe::look(const Surface& surface, const ProbeAim& aim) {
    surface.bindVolumes();
    answer_.bindStorage(SURFACE_BIND_PROBE);
    program_.set("point", glm::vec4(aim.point, aim.reach));
    program_.set("axis", aim.axis);
    program_.dispatchGroups(1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void SurfaceProbe::request(const Surface& surface, const ProbeAim& aim) {
    if (underWay_) return;
    underWay_ = true;
    look(surface, aim);
    readback_.request(answer_);
}

std::optional<SurfaceSounding> SurfaceProbe::poll() {
    const auto answer = readback_.poll<SurfaceProbeAnswer>();
    if (!answer) return std::nullopt;
    underWay_ = false;
    return soundingOf(*answer);
}

SurfaceSounding SurfaceProbe::now(const Surface& surface, const ProbeAim& aim) {
    look(surface, aim);
    return soundingOf(answer_.read<SurfaceProbeAnswer>(1).front());
}

} // namespace meltpool
