// The filter of a welder's visor: one that is always dark, or one that darkens by itself when it sees an arc.
#pragma once

#include <algorithm>

namespace meltpool {

struct VisorSettings {
    float darkShade = 10; ///< shade number over an arc; 0: no visor is worn
    /// Shade number without an arc: 3 to 4 of an auto-darkening filter (EN 379); 0: the filter is always dark.
    float lightShade = 0;
    float switching = 1e-4F; ///< s from light to dark: 0.1 ms of a good one, up to a second of a broken one
};

class VisorFilter {
  public:
    /// s for which it stays dark after the arc went out, so that a pulse does not dazzle, and in which it then clears.
    /// Inside the range of the knob on such visors, 0.1 to 1 s.
    static constexpr double kHold = 0.15, kClearing = 0.25;

    /// Advances the filter. `elapsed`: s since the last call.
    void update(bool arc, double elapsed, const VisorSettings& settings) {
        if (arc) {
            sinceArc_ = 0;
            const double step = elapsed / std::max(static_cast<double>(settings.switching), 1e-6);
            darkened_ = std::min(darkened_ + step, 1.0);
        } else {
            sinceArc_ += elapsed;
            darkened_ = std::min(darkened_, 1 - std::clamp((sinceArc_ - kHold) / kClearing, 0.0, 1.0));
        }
    }

    /// Returns the darkness, 0 light .. 1 dark.
    float darkness() const { return static_cast<float>(darkened_); }
    /// Returns the present shade number; 0 without a visor.
    float shade(const VisorSettings& settings) const {
        if (settings.darkShade <= 0 || settings.lightShade <= 0) return settings.darkShade;
        return settings.lightShade + (settings.darkShade - settings.lightShade) * darkness();
    }

  private:
    double sinceArc_ = kHold + kClearing;
    double darkened_ = 0;
};

} // namespace meltpool
