#include "core/surface/surface_probe.hpp"

namespace meltpool {

SurfaceProbe::SurfaceProbe(gl::ShaderLibrary& shaders)
    : program_(shaders.compute("surface/probe.comp")),
      answer_("surface probe", sizeof(SurfaceProbeAnswer)),
      readback_("surface probe", sizeof(SurfaceProbeAnswer)) {}

void SurfaceProbe::dispatch(const Surface& surface, const ProbeAim& aim) {
    surface.bindVolumes();
    answer_.bindStorage(SURFACE_BIND_PROBE);
    program_.set("point", aim.point);
    program_.set("reach", aim.reach);
    program_.set("axis", aim.axis);
    program_.dispatchGroups(1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void SurfaceProbe::request(const Surface& surface, const ProbeAim& aim) {
    if (pending_) return;
    pending_ = true;
    dispatch(surface, aim);
    readback_.request(answer_);
}

std::optional<SurfaceProbeAnswer> SurfaceProbe::poll() {
    const auto answer = readback_.poll<SurfaceProbeAnswer>();
    if (!answer) return std::nullopt;
    pending_ = false;
    return answer;
}

SurfaceProbeAnswer SurfaceProbe::now(const Surface& surface, const ProbeAim& aim) {
    dispatch(surface, aim);
    return answer_.read<SurfaceProbeAnswer>(1).front();
}

} // namespace meltpool
