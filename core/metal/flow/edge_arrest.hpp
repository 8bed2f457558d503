// Arrest of a liquid's edge on still metal of its own kind. A header of its own: every process sets it without knowing
// the flow.
#pragma once

namespace meltpool {

/// Liquid that reaches cold metal freezes at the line of contact, which stops; it runs on over warm metal. Between both
/// temperatures the wetting changes linearly.
struct EdgeArrest {
    double coldAngle = 0; ///< rad, contact angle on cold metal, see wettingForAngle(); 0: that of warm metal
    double coldShare = 0; ///< share of the solidus in K up to which metal is cold
    double warmShare = 1; ///< share from which it is warm

    bool operator==(const EdgeArrest&) const = default;
};

} // namespace meltpool
