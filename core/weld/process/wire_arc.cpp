#include "core/weld/process/wire_arc.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kReferenceDiameter = 1.2e-3; // m
constexpr double kReferenceAlpha = 0.30e-3;   // m/(A s)
constexpr double kReferenceBeta = 5e-5;       // 1/(A² s)
constexpr double kBreakingStretch = 0.7;
constexpr int kHalvings = 48; // of an interval of some metres: to far below a nanometre

/// V that the machine shows at a current: the set ones, but no more than its short circuit gives.
double terminalVoltage(const WireFeed& feed, double current) {
    return current < kShortCircuitCurrent ? feed.voltage : std::min(feed.voltage, kWireResistance * current);
}

/// Length (m) of the open arc in which a wire of this extension melts as fast as it is fed; 0 where it shorts.
double balancedLength(const WireFeed& feed, double extension) {
    const double current = feed.melting.current(feed.speed, extension);
    return std::max(feed.voltage - kArcFallVoltage - kWireResistance * current, 0.0) / kArcField;
}

} // namespace

WireMelting WireMelting::steel(double diameter) {
    const double ratio = kReferenceDiameter / diameter;
    return {kReferenceAlpha * ratio * ratio, kReferenceBeta * ratio * ratio * ratio * ratio};
}

double WireMelting::speed(double current, double extension) const {
    return alpha * current + beta * std::max(extension, 0.0) * current * current;
}

double WireMelting::current(double speed, double extension) const {
    const double quadratic = beta * std::max(extension, 0.0);
    if (quadratic * speed < 1e-12 * alpha * alpha) return speed / alpha;
    return (std::sqrt(alpha * alpha + 4 * quadratic * speed) - alpha) / (2 * quadratic);
}

double openArcCurrent(const WireFeed& feed, double length) {
    const double left = feed.voltage - kArcFallVoltage - kArcField * std::max(length, 0.0);
    return std::clamp(left / kWireResistance, 0.0, kShortCircuitCurrent);
}

double longestWireArc(const WireFeed& feed) {
    return std::max(feed.voltage - kArcFallVoltage - kWireResistance * kLeastArcCurrent, 0.0) / kArcField;
}

void WireArc::release() {
    lit_ = false;
    action_ = ArcAction::out;
    length_ = current_ = voltage_ = melted_ = stretch_ = 0;
}

/// The machine holds its open-circuit voltage, which here is the set one.
void WireArc::goOut(const WireFeed& feed) {
    release();
    voltage_ = feed.voltage;
}

void WireArc::step(const WireFeed& feed, double distance, double seconds) {
    const bool wasLit = lit_;
    const double metal = std::max(distance, 0.0); // a contact tip inside the metal is at its surface
    if (!lit_) feedInAir(feed, metal, seconds);
    if (!lit_) return;
    // A wire that touches in this step has used its time up: it begins to melt in the next one.
    if (!wasLit) {
        action_ = ArcAction::striking;
        current_ = std::min(kShortCircuitCurrent, feed.voltage / kWireResistance);
        voltage_ = terminalVoltage(feed, current_);
        return;
    }
    burn(feed, metal, seconds);
}

void WireArc::feedInAir(const WireFeed& feed, double distance, double seconds) {
    goOut(feed);
    extension_ += feed.speed * seconds;
    lit_ = extension_ >= distance;
}

void WireArc::burn(const WireFeed& feed, double distance, double seconds) {
    const double before = extension_;
    // Rises with the extension: the longer the wire, the shorter the arc and the more it melts.
    const auto excess = [&](double extension) {
        const double current = openArcCurrent(feed, distance - extension);
        return extension - before - seconds * (feed.speed - feed.melting.speed(current, extension));
    };
    if (!std::isfinite(distance)) {
        goOut(feed);
        extension_ = before + feed.speed * seconds;
        return;
    }
    if (excess(distance) < 0) return shortCircuit(feed, distance, seconds);
    double low = 0, high = distance;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (excess(middle) < 0 ? low : high) = middle;
    }
    extension_ = high;
    length_ = distance - extension_;
    current_ = openArcCurrent(feed, length_);
    if (current_ < kLeastArcCurrent) {
        goOut(feed);
        extension_ = before + feed.speed * seconds;
        return;
    }
    melted_ = before + feed.speed * seconds - extension_;
    voltage_ = feed.voltage;
    const double balanced = balancedLength(feed, extension_);
    stretch_ = std::clamp((length_ - balanced) / std::max(longestWireArc(feed) - balanced, 1e-4), 0.0, 1.0);
    action_ = stretch_ > kBreakingStretch ? ArcAction::breaking : ArcAction::burning;
}

/// The arc cannot keep the wire's end off the metal: it shorts and re-ignites many times in a step, and the mean
/// current is what melts the wire as fast as it comes.
void WireArc::shortCircuit(const WireFeed& feed, double distance, double seconds) {
    const double before = extension_;
    const double arriving = feed.speed - (distance - before) / seconds;
    const double wanted = feed.melting.current(std::max(arriving, 0.0), distance);
    current_ = std::min(wanted, kShortCircuitCurrent);
    const double bearable = wanted > kShortCircuitCurrent ? feed.melting.speed(current_, distance) : arriving;
    extension_ = std::max(before + seconds * (feed.speed - bearable), 0.0);
    melted_ = seconds * bearable;
    length_ = stretch_ = 0;
    voltage_ = terminalVoltage(feed, current_);
    const double arcShare = (feed.voltage - kWireResistance * current_) / kArcFallVoltage;
    action_ = wanted > kShortCircuitCurrent || arcShare < kStubShare ? ArcAction::stubbed : ArcAction::shorting;
}

} // namespace meltpool
