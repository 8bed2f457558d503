// SMAW (stick): a covered electrode that melts off in its own arc, so that the hand follows it down.
#pragma once

#include "core/weld/process/process.hpp"

#include <glm/gtc/quaternion.hpp>

namespace meltpool {

/// Settings on the machine, and the electrode in the holder. Slag and spatter are not represented.
struct SmawSettings {
    float current = 115;     ///< A; the machine's curve is steep, so the current is constant
    int electrode = 0;       ///< index in electrodeNames()
    float diameterMm = 3.2F; ///< diameter of the core
    float lengthMm = 350;
};
ParameterList describe(SmawSettings& settings);

/// Returns "e6013" (rutile), "e7018" (basic), "e6010" (cellulosic).
std::span<const std::string_view> smawElectrodes();

/// Returns the voltage (V) of an arc of `length` (m) and `current` (A) on this electrode. Trade knowledge; no document
/// was checked.
double smawVoltage(int electrode, double length, double current);

/// Returns the length (m) beyond which the arc goes out: it would need kSmawReserve times the machine's load line.
double smawLongestArc(int electrode, double current);

/// Returns the speed (m/s) at which `current` (A) burns off a steel core of `diameter` (m): 8.5 to 9.5 g/(A h), by the
/// electrode.
double smawBurnOff(int electrode, double current, double diameter);

/// The pose of the torch's tip is that of the end of a new electrode. The end of a burnt one is behind it, see
/// burntOff(); releasing the trigger takes a new electrode once the old one has burned to its stub.
class Smaw : public Process {
  public:
    using Settings = SmawSettings;
    static constexpr std::string_view kName = "smaw";
    static const ProcessTraits kTraits;
    static Equipment equipment(const Settings& settings);

    using Process::Process;
    void apply(const ProcessSettings& settings) override;
    /// Starts some way before the electrode's end.
    TorchRay ray(const TorchSample& torch) const override;
    float touchRadius() const override { return settings_.diameterMm * 0.5e-3F; }
    double stirring() const override;
    WireAccount wire() const override;
    float burntOff() const override { return static_cast<float>(burnt_); }
    void reset() override;
    void transfer(gl::StateArchive& archive) override;

  protected:
    void advance(const TorchSample& torch, const MetalAhead& ahead, double seconds) override;

  private:
    void takeAway();
    NoArc whyNot(const TorchSample& torch, double length, double seconds);
    NoArc touch(const TorchSample& torch, double seconds);
    void burn(double length);
    void melt(const TorchSample& torch, double distance, double seconds);
    double area() const;
    double standing() const;

    SmawSettings settings_;
    NoArc noArc_ = NoArc::released; ///< reason in the last step
    bool touched_ = false;          ///< true if the electrode touches
    bool live_ = false;             ///< the electrode has touched since the arc last went out, and may strike
    double touching_ = 0;           ///< s since it met the metal
    glm::quat held_{1, 0, 0, 0};    ///< orientation when it stuck
    double burnt_ = 0;              ///< m burnt off the present electrode
    double melted_ = 0;             ///< m of electrode melted since the start
};

} // namespace meltpool
