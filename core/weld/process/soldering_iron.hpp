// A soldering iron: a hot tip that gives heat to what it touches.
#pragma once

#include "core/weld/process/process.hpp"

namespace meltpool {

struct IronSettings {
    float tipTemperatureC = 380;
    float tipRadiusMm = 2;
};
ParameterList describe(IronSettings& settings);

class SolderingIron : public Process {
  public:
    using Settings = IronSettings;
    static constexpr std::string_view kName = "iron";

    using Process::Process;
    void apply(const ProcessSettings& settings) override;
    float touchRadius() const override { return settings_.tipRadiusMm * 1e-3F; }

  protected:
    void advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) override;

  private:
    IronSettings settings_;
};

} // namespace meltpool
