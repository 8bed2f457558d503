// Finds the distance from the torch's tip to the metal on the shown surface, in metres of the workpiece's frame.
#pragma once

#include "core/surface/surface_probe.hpp"
#include "core/training/trainer/metal_model.hpp"
#include "core/weld/process/tip_touch.hpp"

namespace meltpool {

class TipProbe {
  public:
    /// Reach of the search from the tip, m.
    static constexpr float kReach = 0.06F;

    explicit TipProbe(gl::ShaderLibrary& shaders) : probe_(shaders) {}

    /// Requests the place of `surface` of `metal` under this torch; dropped while an answer is pending.
    void request(const Surface& surface, const MetalModel& metal, const TorchSample& torch);
    /// The answer, once, some frames later; never waits.
    std::optional<SurfaceDistance> poll(const MetalModel& metal);
    /// Drops the request: the metal was replaced.
    void forget() { probe_.forget(); }
    /// Waits for the GPU.
    SurfaceDistance now(const Surface& surface, const MetalModel& metal, const TorchSample& torch);

  private:
    SurfaceProbe probe_;
};

} // namespace meltpool
