// The electric circuit of a GMAW torch on a constant-voltage machine: wire extension, arc length and current, which
// regulate each other. It has no welding beyond the wire: pure numbers in SI units.
#pragma once

#include "core/weld/process/arc.hpp"

namespace meltpool {

/// Melting speed of a wire: alpha I + beta s I² (m/s) with the extension s. The first term is the arc's heat, the
/// second the resistance of the wire (Lesnewich 1958; Halmoy 1979). alpha and beta are for steel, scaled by the
/// cross-section from kReferenceAlpha and kReferenceBeta.
struct WireMelting {
    double alpha = 0; ///< m/(A s)
    double beta = 0;  ///< 1/(A² s)

    static WireMelting steel(double diameter); ///< Returns the melting of a steel wire of this diameter, m.
    /// Returns the speed (m/s) at which a current (A) melts a wire of this extension (m).
    double speed(double current, double extension) const;
    /// Returns the current (A) that melts the wire at `speed`; the inverse of speed().
    double current(double speed, double extension) const;
};

/// Settings on the machine's panel.
struct WireFeed {
    double voltage = 20; ///< V at the terminals, which the machine holds
    double speed = 0.1;  ///< m/s of wire
    WireMelting melting;
    double meltingEnergy = 0;      ///< J of electric energy that melt a metre of wire, losses included; 0: unknown
    double gasVoltage = 0;         ///< V more for the arc than kArcFallVoltage, see ShieldingGas::arcVoltage
    bool controlledShorts = false; ///< the machine ends each short circuit: none lasts
};

/// One wire on one machine. Between steps it stores the extension and the state of the arc.
class WireArc {
  public:
    explicit WireArc(double extension = 0) : extension_(extension) {}

    /// Advances by `seconds` with the metal `distance` (m) from the contact tip, infinite if there is none, while the
    /// wire is fed. The current follows from arc = distance - extension = (U - V0 - R I)/E and d(extension)/dt = feed -
    /// melting, solved implicitly at the step's end, as their time constants are as short as the step. No more wire
    /// melts than the electric power can melt; the rest adds to the extension. A contact tip on the metal lets no wire
    /// through.
    void step(const WireFeed& feed, double distance, double seconds);
    /// Stops the wire and puts the arc out.
    void release();

    /// Saves or restores the state.
    void transfer(gl::StateArchive& archive);

    ArcAction action() const { return action_; }
    NoArc noArc() const { return noArc_; }          ///< reason for action() `out`
    double extension() const { return extension_; } ///< m; more than the distance: the wire is bent
    double length() const { return length_; }       ///< m, length of the arc
    double current() const { return current_; }     ///< A
    double voltage() const { return voltage_; }     ///< V at the terminals
    double fed() const { return fed_; }             ///< m of wire that came through the contact tip in the last step
    double melted() const { return melted_; }       ///< m of wire that melted in the last step
    double stretch() const { return stretch_; }     ///< 0..1, see ArcState

  private:
    void feedInAir(const WireFeed& feed, double distance, double seconds);
    void burn(const WireFeed& feed, double distance, double seconds);
    void shortCircuit(const WireFeed& feed, double distance, double seconds);
    void goOut(const WireFeed& feed, NoArc reason);
    void block(const WireFeed& feed);

    double extension_;
    bool lit_ = false;
    ArcAction action_ = ArcAction::out;
    NoArc noArc_ = NoArc::released;
    double length_ = 0, current_ = 0, voltage_ = 0, fed_ = 0, melted_ = 0, stretch_ = 0;
};

/// Returns the current (A) of an open arc with the wire's end `length` (m) from the metal: (U - V0 - E length)/R, not
/// below 0 nor above the machine's short circuit.
double openArcCurrent(const WireFeed& feed, double length);

/// Returns the length (m) of the open arc that this current (A) leaves; 0: the wire dips.
double openArcLength(const WireFeed& feed, double current);

/// Returns the share of the time, 0 to 1, that an arc of this mean current (A) burns, as a short circuit has no
/// voltage.
double arcTime(const WireFeed& feed, double current);

/// Returns the extension (m) of the wire at this current (A) with the metal `distance` (m) from the contact tip: the
/// distance less the open arc; all of it in dip transfer. The machine's speed is not used.
double wireExtension(const WireFeed& feed, double distance, double current);
/// Returns the speed (m/s) at which the machine must feed the wire so that it melts with this current (A).
double feedAtCurrent(const WireFeed& feed, double distance, double current);

/// Returns the length (m) at which an open arc goes out.
double longestWireArc(const WireFeed& feed);

} // namespace meltpool
