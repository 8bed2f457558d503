// What the hand feels: vibration as a pure function of what happens at the torch's tip, never of the button.
#pragma once

#include "core/weld/process/arc.hpp"

#include <limits>

namespace meltpool {

/// What happens at the tip in this frame.
struct TipFeel {
    double time = 0; ///< seconds; carries the rhythm
    ArcState arc;
    double sinceTouch = std::numeric_limits<double>::infinity(); ///< seconds since the tip met the metal
    float touchSpeed = 0;                                        ///< m/s, at that moment
    double shorts = 0; ///< short circuits so far and the share of the way to the next, see ShortCircuits::phase()
};

/// What the hand is to feel from now on; renewed every frame while it lasts.
struct Vibration {
    float amplitude = 0; ///< 0..1; 0: silence
    float frequency = 0; ///< Hz; 0: the device's own choice
    float duration = 0;  ///< seconds
    bool silent() const { return amplitude <= 0.0f; }
    bool operator==(const Vibration&) const = default;
};

/// Hum with arc or flame (amplitude grows with the power that arrives and sinks with a long arc, frequency falls with a
/// long arc and over liquid metal); stutter of kBreakRate a second where the arc is about to break; where drops bridge
/// it a stutter with the short circuits that are heard, one pulse for kShortsPerPulse of them, or of kTouchRate a
/// second where an electrode stands in the pool; a rough buzz where the wire stubs; a knock when the tip meets the
/// metal, dull on liquid, which outweighs the rest while it lasts. Nothing happens at the tip: silence.
Vibration feel(const TipFeel& tip);

constexpr double kBreakRate = 9;  ///< 1/s
constexpr double kTouchRate = 20; ///< 1/s
/// Real short circuits, 50 to 200 a second, would be lost between the frames.
constexpr double kShortsPerPulse = 6;

/// How long a touch is felt, s.
constexpr double kKnockDuration = 0.03;

} // namespace meltpool
