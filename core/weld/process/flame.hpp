// A gas flame: heat from the burner, without current or filler.
#pragma once

#include "core/weld/process/process.hpp"

namespace meltpool {

struct FlameSettings {
    float power = 1500; ///< W into the metal
    float sigmaMm = 2;  ///< spread of the heat on the surface
};
ParameterList describe(FlameSettings& settings);

class Flame : public Process {
  public:
    using Settings = FlameSettings;
    static constexpr std::string_view kName = "flame";

    using Process::Process;
    void apply(const ProcessSettings& settings) override;

  protected:
    void advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) override;

  private:
    FlameSettings settings_;
};

} // namespace meltpool
