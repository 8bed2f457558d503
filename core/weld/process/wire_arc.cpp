#include "core/weld/process/wire_arc.hpp"

#include "core/gl/state_archive.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kBreakingStretch = 0.7;
constexpr int kHalvings = 48; // number of halvings of an interval of some metres: to far below a nanometre

/// Returns the falls (V) at the arc's ends in the machine's gas.
double fallVoltage(const WireFeed& feed) {
    return kArcFallVoltage + feed.gasVoltage;
}

/// Returns the machine's voltage (V) at a current: the set one, but no more than its short circuit gives.
double terminalVoltage(const WireFeed& feed, double current) {
    return current < kShortCircuitCurrent ? feed.voltage : std::min(feed.voltage, kWireResistance * current);
}

/// Returns the current (A) of the machine into a wire that touches.
double shortCurrent(const WireFeed& feed) {
    return std::min(kShortCircuitCurrent, feed.voltage / kWireResistance);
}

/// Returns the speed (m/s of wire) at which a current melts it at a voltage: as measured, but no more than the electric
/// power can melt.
double meltingSpeed(const WireFeed& feed, double current, double voltage, double extension) {
    const double measured = feed.melting.speed(current, extension);
    return feed.meltingEnergy > 0 ? std::min(measured, voltage * current / feed.meltingEnergy) : measured;
}

/// Returns the length (m) of the open arc in which a wire of this extension melts as fast as it is fed; 0 if it shorts.
double balancedLength(const WireFeed& feed, double extension) {
    return openArcLength(feed, feed.melting.current(feed.speed, extension));
}

} // namespace

WireMelting WireMelting::steel(double diameter) {
    const double ratio = kReferenceWire / diameter;
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
    const double left = feed.voltage - fallVoltage(feed) - kArcField * std::max(length, 0.0);
    return std::clamp(left / kWireResistance, 0.0, kShortCircuitCurrent);
}

double openArcLength(const WireFeed& feed, double current) {
    return std::max(feed.voltage - fallVoltage(feed) - kWireResistance * current, 0.0) / kArcField;
}

double wireExtension(const WireFeed& feed, double distance, double current) {
    return std::max(distance - openArcLength(feed, current), 0.0);
}

double feedAtCurrent(const WireFeed& feed, double distance, double current) {
    return feed.melting.speed(current, wireExtension(feed, distance, current));
}

double arcTime(const WireFeed& feed, double current) {
    return std::clamp((feed.voltage - kWireResistance * current) / fallVoltage(feed), 0.0, 1.0);
}

double longestWireArc(const WireFeed& feed) {
    return std::max(feed.voltage - fallVoltage(feed) - kWireResistance * kLeastArcCurrent, 0.0) / kArcField;
}

void WireArc::release() {
    lit_ = false;
    action_ = ArcAction::out;
    noArc_ = NoArc::released;
    length_ = current_ = voltage_ = fed_ = melted_ = stretch_ = 0;
}

void WireArc::transfer(gl::StateArchive& archive) {
    archive.values(extension_, lit_, action_, noArc_, length_, current_, voltage_, fed_, melted_, stretch_);
}

/// The machine holds its open-circuit voltage, which here is the set one.
void WireArc::goOut(const WireFeed& feed, NoArc reason) {
    release();
    noArc_ = reason;
    voltage_ = feed.voltage;
}

void WireArc::step(const WireFeed& feed, double distance, double seconds) {
    const bool wasLit = lit_;
    if (distance < kBlockedTip) return block(feed);
    fed_ = feed.speed * seconds;
    if (!lit_) feedInAir(feed, distance, seconds);
    if (!lit_) return;
    // A wire that touches in this step has used its time up: it begins to melt in the next one.
    noArc_ = NoArc::burns;
    if (!wasLit) {
        action_ = ArcAction::striking;
        current_ = shortCurrent(feed);
        voltage_ = terminalVoltage(feed, current_);
        return;
    }
    burn(feed, distance, seconds);
}

/// The current goes through the contact tip, and the feeder's rolls slip.
void WireArc::block(const WireFeed& feed) {
    release();
    action_ = ArcAction::stubbed;
    noArc_ = NoArc::burns;
    current_ = shortCurrent(feed);
    voltage_ = terminalVoltage(feed, current_);
}

void WireArc::feedInAir(const WireFeed& feed, double distance, double seconds) {
    goOut(feed, wentOut(noArc_) ? noArc_ : std::isfinite(distance) ? NoArc::feeding : NoArc::noMetal);
    fed_ = feed.speed * seconds;
    extension_ += feed.speed * seconds;
    lit_ = extension_ >= distance;
}

void WireArc::burn(const WireFeed& feed, double distance, double seconds) {
    const double before = extension_;
    // The excess rises with the extension: the longer the wire, the shorter the arc and the more it melts.
    const auto excess = [&](double extension) {
        const double current = openArcCurrent(feed, distance - extension);
        return extension - before - seconds * (feed.speed - meltingSpeed(feed, current, feed.voltage, extension));
    };
    if (!std::isfinite(distance)) {
        goOut(feed, NoArc::metalLeft);
        fed_ = feed.speed * seconds;
        extension_ = before + fed_;
        return;
    }
    const bool nearby = distance - before < kLongestDipArc;
    const bool cannotStayOpen = balancedLength(feed, std::min(before, distance)) <= 0;
    if (excess(distance) < 0 || (nearby && cannotStayOpen)) return shortCircuit(feed, distance, seconds);
    double low = 0, high = distance;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (excess(middle) < 0 ? low : high) = middle;
    }
    extension_ = high;
    length_ = distance - extension_;
    current_ = openArcCurrent(feed, length_);
    if (current_ < kLeastArcCurrent) {
        goOut(feed, NoArc::tooLong);
        fed_ = feed.speed * seconds;
        extension_ = before + fed_;
        return;
    }
    melted_ = before + feed.speed * seconds - extension_;
    voltage_ = feed.voltage;
    const double balanced = balancedLength(feed, extension_);
    stretch_ = std::clamp((length_ - balanced) / std::max(longestWireArc(feed) - balanced, 1e-4), 0.0, 1.0);
    action_ = stretch_ > kBreakingStretch ? ArcAction::breaking : ArcAction::burning;
}

/// The arc cannot hold the wire's end off the metal: it shorts and re-ignites again and again, and the mean current is
/// the one that melts the wire as fast as it comes. The pool heaves under the wire, which follows it within some short
/// circuits.
void WireArc::shortCircuit(const WireFeed& feed, double distance, double seconds) {
    const double before = extension_;
    const double hot = std::min(before, distance); // wire that is in the metal already carries no current of its own
    const double arriving = feed.speed - (distance - before) / std::max(kDipTime, seconds);
    const double wanted = feed.melting.current(std::max(arriving, 0.0), hot);
    const double most = shortCurrent(feed);
    current_ = std::min(wanted, most);
    voltage_ = terminalVoltage(feed, current_);
    const double melting = meltingSpeed(feed, current_, voltage_, hot);
    const double bearable = std::min(std::max(arriving, 0.0), melting);
    extension_ = std::max(before + seconds * (feed.speed - bearable), 0.0);
    melted_ = seconds * bearable;
    length_ = stretch_ = 0;
    const double arcShare = (feed.voltage - kWireResistance * current_) / fallVoltage(feed);
    const bool stays = !feed.controlledShorts && arcShare < kStubShare;
    action_ = bearable < arriving - 1e-9 || stays ? ArcAction::stubbed : ArcAction::shorting;
}

} // namespace meltpool
