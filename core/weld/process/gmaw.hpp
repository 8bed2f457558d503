// GMAW (MIG/MAG): a wire that is fed at constant speed and melts in the arc of a constant-voltage machine.
#pragma once

#include "core/weld/process/process.hpp"
#include "core/weld/process/wire_arc.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace meltpool {

struct ShieldingGas;

/// How the machine ends the wire's short circuits.
enum class ShortCircuitKind : std::uint8_t {
    ordinary,   ///< the current rises until the bridge bursts
    controlled, ///< the machine cuts the current, or draws the wire back, before the bridge opens (STT, CMT)
};

/// Returns the kind of this name, "ordinary" or "controlled"; none for another name.
std::optional<ShortCircuitKind> findShortCircuits(std::string_view name);

/// Settings on the machine's panel, and the wire in it. The current is not set: it follows.
struct GmawSettings {
    float voltage = 19; ///< V at the torch
    float wireFeedMPerMin = 5.8F;
    float wireDiameterMm = 0.9F;
    int inductance = 1; ///< 0 low, 1 medium, 2 high
    /// The torch's pose is that of the end of a wire with this extension from the contact tip.
    float stickOutMm = 12;
    int gas = 0; ///< GasKind
    float gasFlowLMin = 14;
    int shortCircuits = 0; ///< ShortCircuitKind
};
ParameterList describe(GmawSettings& settings);

/// Returns 0 for a wire of `diameterMm` that dips or lets large drops fall at this current (A) in this gas, 1 for one
/// that sprays.
double sprayShare(double current, double diameterMm, const ShieldingGas& gas);

/// Returns the radius (m, sigma) of the heat of a spraying arc of `current` (A), see kSprayRadius.
double sprayHeatRadius(double current);

class Gmaw : public Process {
  public:
    using Settings = GmawSettings;
    static constexpr std::string_view kName = "gmaw";
    static const ProcessTraits kTraits;
    static Equipment equipment(const Settings& settings);

    explicit Gmaw(const ProcessMetal& metal);
    void apply(const ProcessSettings& settings) override;
    /// Starts at the contact tip; longer for a long extension.
    TorchRay ray(const TorchSample& torch) const override;
    WireAccount wire() const override;
    float touchRadius() const override { return settings_.wireDiameterMm * 0.5e-3F; }
    double stirring() const override;
    EdgeArrest edgeArrest() const override;
    void reset() override;
    void transfer(gl::StateArchive& archive) override;

  protected:
    double dropTemperature() const override;
    void advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) override;

  private:
    WireFeed feed() const;
    double settledCurrent() const;
    double shortsLeft(double length, double current) const;
    double dipping() const;
    float mostShorts() const;
    double wireArea() const;
    void takeOver();
    void transferHeat(const TorchSample& torch, double seconds);

    GmawSettings settings_;
    WireArc wire_;
    double fed_ = 0, melted_ = 0; ///< m of wire since the start
};

} // namespace meltpool
