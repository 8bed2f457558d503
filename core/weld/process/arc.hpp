// The arc (or flame, or iron) at one moment: computed once a step by the process, and read by metal, hand, ear, eye,
// score and record.
#pragma once

#include <glm/vec3.hpp>

#include <limits>
#include <string_view>

namespace meltpool::gl {
class StateArchive;
}

namespace meltpool {

enum class ArcAction {
    out,      ///< no heat
    striking, ///< the first step of an arc
    burning,  ///< an open arc; a flame or an iron at work
    shorting, ///< the wire's end touches the pool again and again (dip transfer)
    stubbed,  ///< the wire pushes against the metal faster than it melts
    breaking, ///< so long that the arc is about to go out
};

/// The word for an action in records and results: "out", "striking" ...
std::string_view arcActionName(ArcAction action);

/// Why a torch has no arc.
enum class NoArc {
    burns,     ///< it has one; also every process that is no arc
    released,  ///< the trigger is let go
    tooLong,   ///< it went out: the machine could not hold an arc of this length
    touched,   ///< it went out: the electrode met the metal under it and is spoiled
    metalLeft, ///< it went out: no metal lies before the torch any more
    noMetal,   ///< it does not strike: no metal lies before the torch
    tooFar,    ///< it does not strike: the spark does not jump so far
    touching,  ///< it does not strike: the electrode stands on the metal
    feeding,   ///< it does not strike yet: the wire is on its way to the metal
    noWire,    ///< it does not strike: no wire is fed
    stuck,     ///< the electrode is frozen to the metal, with or without an arc before
    usedUp,    ///< it went out: the electrode has burned down to its stub
};

/// The word for records: "too_long", "touched" ...
std::string_view noArcName(NoArc reason);

/// An arc burned and went out by itself (one that never burned can be stuck, too), the trigger pulled; the reason stays
/// until it strikes again or the trigger is let go.
constexpr bool wentOut(NoArc reason) {
    return reason == NoArc::tooLong || reason == NoArc::touched || reason == NoArc::metalLeft ||
           reason == NoArc::stuck || reason == NoArc::usedUp;
}

/// All lengths in m, in SI.
struct ArcState {
    ArcAction action = ArcAction::out;
    NoArc noArc = NoArc::burns;                              ///< why action is `out`
    float distance = std::numeric_limits<float>::infinity(); ///< from the torch's contact tip, electrode or nozzle
                                                             ///< along its axis to the metal; infinite: none in reach
    float extension = 0;                                     ///< of the wire beyond the contact tip, of an electrode
                                                             ///< that burns off what is left of it; or 0
    float length = 0;                                        ///< of the arc; 0 without one and while the wire touches
    float current = 0;                                       ///< A, mean over the step
    float voltage = 0;                                       ///< V between torch and workpiece, mean over the step
    double power = 0;                                        ///< W into the metal, with what the drops bring
    float radius = 0;                                        ///< sigma of the heat on the surface
    float pressure = 0;                                      ///< Pa on the axis
    float shorts = 0;                                        ///< 1/s, short circuits of the wire
    float share = 0;    ///< 0..1 of what the process can give: what arrives in the metal
    float stretch = 0;  ///< 0 the length that the settings give .. 1 about to go out
    float liquid = 0;   ///< 0..1, share of liquid in the metal under the axis
    float rodEaten = 0; ///< of a filler rod: how far its end lies behind RodSample::tip
    float rodBall = 0;  ///< diameter of the ball on its end; 0 without
    bool rodInPool = false;

    bool burns() const { return action != ArcAction::out; }
    /// Saves or restores it.
    void transfer(gl::StateArchive& archive);
};

/// Standard deviation (m) of the heat flux of an arc of `length` (m) and `current` (A) on the surface:
/// 0.53 mm (L/mm)^0.29 (I/A)^0.30 as measured on copper anodes with GTAW, times kArcSpread. Arcs shorter than
/// kShortestSpread count as that long.
double arcHeatRadius(double length, double current);

/// Times the metal's own conductivity that its liquid conducts under an arc of `current` (A): the stirring by the
/// current's own magnetic force, by drops and by surface tension, which particles of a millimetre do not resolve. The
/// magnetic force drives liquid at a speed proportional to the current (Kou and Sun 1985), and what liquid carries
/// grows with its speed: 1 + I / kStirringCurrent. The same law for every arc weld and spacing.
double arcStirring(double current);

/// Shares of what a stirred pool conducts that it conducts along its surface and down into the metal.
struct StirringShares {
    double along = 1, down = 1;
};

/// Where the pull of the surface's tension leads the heat of a pool that nothing else mixes. `pull` (N/m): tension at
/// the liquidus less that half-way to the arc, see kHalfWayToArc. Where it is positive the surface flows outwards and
/// spreads its heat; where sulphur turns the slope, inwards and down. Particles of a millimetre do not flow so: the
/// other direction conducts less instead, down to kLeastStirring from kWholePull on. Conductivities that differ by
/// direction in place of this flow: Safdar, Li and Sheikh 2013; Kollmannsberger, Carraturo, Reali and Auricchio 2019.
StirringShares pulledStirring(double pull);

/// What stirred liquid conducts less along x, y and z, for a pool whose surface is across `axis`, a unit vector. A pool
/// that lies aslant to all axes keeps only what falls on them.
glm::vec3 stirringLess(const StirringShares& shares, glm::vec3 axis);

} // namespace meltpool
