// GTAW (TIG): a tungsten electrode on a machine that holds the current; the arc's voltage follows its length.
#pragma once

#include "core/weld/process/rod_process.hpp"

namespace meltpool {

struct GtawSettings {
    float current = 130; ///< A with the trigger or pedal pulled through; a smaller pull gives less current
    float electrodeDiameterMm = 2.4F;
    float rodDiameterMm = 2.4F; ///< diameter of the filler rod in the other hand; 0: none is held
    int gas = 0;                ///< argon, the only choice
};
ParameterList describe(GtawSettings& settings);

/// Returns the voltage (V) of an argon arc of `length` (m) and `current` (A): 9 V + 0.9 V/mm + 0.01 V/A. Start values
/// from handbooks that give 0.8 to 1 V/mm; no document was checked.
double gtawVoltage(double length, double current);

/// Returns the length (m) beyond which an arc of `current` (A) goes out: it would need 1.35 times the machine's load
/// line, 10 V + 0.04 V/A (IEC 60974-1). At the load line itself it begins to break. The factor has no source: it puts
/// the end of a 130 A arc at 11 mm.
double gtawLongestArc(double current);

class Gtaw : public RodProcess {
  public:
    using Settings = GtawSettings;
    static constexpr std::string_view kName = "gtaw";
    static const ProcessTraits kTraits;
    static Equipment equipment(const Settings& settings);

    using RodProcess::RodProcess;
    void apply(const ProcessSettings& settings) override;
    float touchRadius() const override { return settings_.electrodeDiameterMm * 0.5e-3F; }
    double stirring() const override { return arcStirring(static_cast<double>(settings_.current)); }
    bool stirredByTension() const override { return true; }
    void reset() override;
    void transfer(gl::StateArchive& archive) override;

    /// Returns true if the electrode touched the metal or the rod while its arc burned: it is spoiled until it is
    /// ground.
    bool electrodeSpoiled() const { return spoiled_; }

  protected:
    void advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) override;

  private:
    NoArc whyNot(const TorchSample& torch, const MetalAhead& ahead, double current) const;
    void strikeOrBurn(const TorchSample& torch, const MetalAhead& ahead);

    GtawSettings settings_;
    NoArc noArc_ = NoArc::released; ///< reason in the last step
    bool released_ = true;          ///< the trigger was released since the arc last went out
    bool spoiled_ = false;
};

} // namespace meltpool
