// A gas flame: heat from the burner, without current; the other hand may hold a filler rod.
#pragma once

#include "core/weld/process/rod_process.hpp"

namespace meltpool {

struct FlameSettings {
    float power = 1500;      ///< W into metal that catches the whole flame
    float sigmaMm = 2;       ///< spread of the heat on the surface
    float lengthMm = 60;     ///< distance from the tip beyond which nothing is heated
    float rodDiameterMm = 0; ///< diameter of the filler rod in the other hand; 0: none is held
};
ParameterList describe(FlameSettings& settings);

class Flame : public RodProcess {
  public:
    using Settings = FlameSettings;
    static constexpr std::string_view kName = "flame";
    static const ProcessTraits kTraits;
    static Equipment equipment(const Settings& settings);

    using RodProcess::RodProcess;
    void apply(const ProcessSettings& settings) override;
    TorchRay ray(const TorchSample& torch) const override;

  protected:
    void advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) override;

  private:
    float shareAt(float distance) const;

    FlameSettings settings_;
};

} // namespace meltpool
