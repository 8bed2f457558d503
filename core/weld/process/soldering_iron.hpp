// A soldering iron: a hot tip that heats the metal that it touches; the other hand may hold wire solder.
#pragma once

#include "core/weld/process/rod_process.hpp"

namespace meltpool {

struct IronSettings {
    float tipTemperatureC = 380;
    float tipRadiusMm = 2;
    float rodDiameterMm = 0; ///< diameter of the wire solder in the other hand; 0: none is held
};
ParameterList describe(IronSettings& settings);

class SolderingIron : public RodProcess {
  public:
    using Settings = IronSettings;
    static constexpr std::string_view kName = "iron";
    static const ProcessTraits kTraits;
    static Equipment equipment(const Settings& settings);

    using RodProcess::RodProcess;
    void apply(const ProcessSettings& settings) override;
    float touchRadius() const override { return settings_.tipRadiusMm * 1e-3F; }

  protected:
    void advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) override;

  private:
    double meltSolder(const TorchSample& torch, double seconds);

    IronSettings settings_;
};

} // namespace meltpool
