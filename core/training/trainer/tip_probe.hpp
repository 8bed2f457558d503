// Where the metal lies from the torch's tip, in metres of the workpiece's frame, found on the surface that is shown.
#pragma once

#include "core/surface/surface_probe.hpp"
#include "core/training/trainer/metal_model.hpp"
#include "core/weld/process/tip_touch.hpp"

namespace meltpool {

class TipProbe {
  public:
    /// How far from the tip metal is looked for, m.
    static constexpr float kReach = 0.06F;

    explicit TipProbe(gl::ShaderLibrary& shaders) : probe_(shaders) {}

    /// Asks where `surface` of `metal` lies under this torch; dropped while an answer is under way.
    void request(const Surface& surface, const MetalModel& metal, const TorchSample& torch);
    /// The answer, once, frames later; never waits.
    std::optional<SurfaceDistance> poll(const MetalModel& metal);
    /// Drops what was asked for: the metal is another one now.
    void forget() { probe_.forget(); }
    /// Waits for the GPU.
    SurfaceDistance now(const Surface& surface, const MetalModel& metal, const TorchSample& torch);

  private:
    SurfaceProbe probe_;
};

} // namespace meltpool
