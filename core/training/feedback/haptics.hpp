// Computes the vibration of the hand from the events at the torch's tip alone, never from the button.
#pragma once

#include "core/weld/process/arc.hpp"

#include <limits>

namespace meltpool {

/// Events at the tip in this frame.
struct TipFeel {
    double time = 0; ///< seconds; sets the rhythm
    ArcState arc;
    double sinceTouch = std::numeric_limits<double>::infinity(); ///< seconds since the tip met the metal
    float touchSpeed = 0;                                        ///< m/s, at that touch
    double shorts = 0; ///< short circuits so far and the share of the way to the next, see ShortCircuits::phase()
};

/// Vibration from now on; renewed every frame while it lasts.
struct Vibration {
    float amplitude = 0; ///< 0..1; 0: silence
    float frequency = 0; ///< Hz; 0: the device's own choice
    float duration = 0;  ///< seconds
    bool silent() const { return amplitude <= 0.0f; }
    bool operator==(const Vibration&) const = default;
};

/// Vibration for the tip: a hum with arc or flame (its amplitude grows with the power that arrives and falls with a
/// long arc, its frequency falls with a long arc and over liquid metal); a stutter of kBreakRate a second when the arc
/// is about to break; with bridging drops a stutter with the audible short circuits, one pulse for kShortsPerPulse of
/// them, or of kTouchRate a second for an electrode in the pool; a rough buzz for a stubbing wire; a knock when the tip
/// touches the metal, dull on liquid, which outweighs the rest while it lasts. Silence without an event.
Vibration feel(const TipFeel& tip);

constexpr double kBreakRate = 9;  ///< 1/s
constexpr double kTouchRate = 20; ///< 1/s
/// Real short circuits, 50 to 200 a second, are too fast for the frames.
constexpr double kShortsPerPulse = 6;

/// Duration of a knock, s.
constexpr double kKnockDuration = 0.03;

} // namespace meltpool
