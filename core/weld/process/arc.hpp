// The arc (or flame, or iron) at one moment: the process computes it once a step; metal, hand, ear, eye, score and
// record read it.
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
    striking, ///< first step of an arc
    burning,  ///< open arc; a flame or an iron at work
    shorting, ///< dip transfer: the wire's end touches the pool again and again
    stubbed,  ///< the wire pushes against the metal faster than it melts
    breaking, ///< an arc so long that it is about to go out
};

/// Returns the word for an action in records and results: "out", "striking" ...
std::string_view arcActionName(ArcAction action);

/// Reason why a torch has no arc.
enum class NoArc {
    burns,     ///< there is an arc; also every process that is no arc
    released,  ///< the trigger is released
    tooLong,   ///< the arc went out: the machine could not hold an arc of this length
    touched,   ///< the arc went out: the electrode met the metal under it and is spoiled
    metalLeft, ///< the arc went out: there is no metal before the torch any more
    noMetal,   ///< the arc does not strike: there is no metal before the torch
    tooFar,    ///< the arc does not strike: the spark does not jump so far
    touching,  ///< the arc does not strike: the electrode touches the metal
    feeding,   ///< the arc does not strike yet: the wire is on its way to the metal
    noWire,    ///< the arc does not strike: no wire is fed
    stuck,     ///< the electrode is frozen to the metal, with or without an arc before
    usedUp,    ///< the arc went out: the electrode has burned down to its stub
};

/// Returns the word for records: "too_long", "touched" ...
std::string_view noArcName(NoArc reason);

/// Returns true if an arc burned and went out by itself (one that never burned can be stuck, too) with the trigger
/// pulled; the reason stays until the arc strikes again or the trigger is released.
constexpr bool wentOut(NoArc reason) {
    return reason == NoArc::tooLong || reason == NoArc::touched || reason == NoArc::metalLeft ||
           reason == NoArc::stuck || reason == NoArc::usedUp;
}

/// All lengths in m, in SI.
struct ArcState {
    ArcAction action = ArcAction::out;
    NoArc noArc = NoArc::burns; ///< reason for `out`
    /// Distance from the torch's contact tip, electrode or nozzle along its axis to the metal; infinite: none in reach.
    float distance = std::numeric_limits<float>::infinity();
    /// Length of the wire beyond the contact tip, or the remaining length of an electrode that burns off; else 0.
    float extension = 0;
    /// Length of the arc; 0 without one and while the wire touches.
    float length = 0;
    float current = 0;  ///< A, mean over the step
    float voltage = 0;  ///< V between torch and workpiece, mean over the step
    double power = 0;   ///< W into the metal, with the heat of the drops
    float radius = 0;   ///< sigma of the heat on the surface
    float pressure = 0; ///< Pa on the axis
    float shorts = 0;   ///< 1/s, short circuits of the wire
    float share = 0;    ///< 0..1, share of the process's full heat that arrives in the metal
    float stretch = 0;  ///< 0: the length at the set values .. 1: about to go out
    float liquid = 0;   ///< 0..1, share of liquid in the metal under the axis
    float rodEaten = 0; ///< distance of a filler rod's end behind RodSample::tip
    float rodBall = 0;  ///< diameter of the ball on its end; 0 without
    bool rodInPool = false;

    bool burns() const { return action != ArcAction::out; }
    /// Saves or restores the state.
    void transfer(gl::StateArchive& archive);
};

/// Returns the standard deviation (m) of the heat flux of an arc of `length` (m) and `current` (A) on the surface: 0.53
/// mm (L/mm)^0.29 (I/A)^0.30 as measured on copper anodes with GTAW, times kArcSpread. Arcs shorter than
/// kShortestSpread count as that long.
double arcHeatRadius(double length, double current);

/// Returns the factor on the metal's own conductivity for its liquid under an arc of `current` (A): the stirring by the
/// current's own magnetic force, by drops and by surface tension, which particles of a millimetre do not resolve. The
/// magnetic force drives liquid at a speed proportional to the current (Kou and Sun 1985), and the heat that liquid
/// carries grows with its speed: 1 + I / kStirringCurrent. One law for every arc weld and spacing.
double arcStirring(double current);

/// Shares of a stirred pool's conductivity: along its surface and down into the metal.
struct StirringShares {
    double along = 1, down = 1;
};

/// Returns the directions in which surface tension leads the heat of a pool that nothing else mixes. `pull` (N/m):
/// tension at the liquidus less that half-way to the arc, see kHalfWayToArc. A positive pull makes the surface flow
/// outwards and spread its heat; where sulphur turns the slope it flows inwards and down. Particles of a millimetre do
/// not flow so: the other direction conducts less instead, down to kLeastStirring from kWholePull on. Conductivities
/// that differ by direction in place of this flow: Safdar, Li and Sheikh 2013; Kollmannsberger, Carraturo, Reali and
/// Auricchio 2019.
StirringShares pulledStirring(double pull);

/// Returns the reduction of stirred liquid's conductivity along x, y and z, for a pool whose surface is across `axis`,
/// a unit vector. A pool that is aslant to all axes gets only the share that falls on them.
glm::vec3 stirringLess(const StirringShares& shares, glm::vec3 axis);

} // namespace meltpool
