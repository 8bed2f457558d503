// The electric circuit of a GMAW torch on a constant-voltage machine: wire extension, arc length and current, which
// regulate each other. No welding here beyond the wire: pure numbers in SI units.
#pragma once

#include "core/weld/process/arc.hpp"

namespace meltpool {

/// How fast a wire melts: alpha I + beta s I² (m/s) with the extension s. The first term is the arc's heat, the second
/// the resistance of the wire (Lesnewich 1958; Halmoy 1979). alpha and beta are for steel, scaled by the cross-section
/// from kReferenceAlpha and kReferenceBeta.
struct WireMelting {
    double alpha = 0; ///< m/(A s)
    double beta = 0;  ///< 1/(A² s)

    static WireMelting steel(double diameter); ///< of the wire, m
    /// Speed (m/s) at which a current (A) melts a wire of this extension (m).
    double speed(double current, double extension) const;
    /// The current (A) that melts the wire at `speed`; the inverse of speed().
    double current(double speed, double extension) const;
};

/// What the machine's panel is set to.
struct WireFeed {
    double voltage = 20; ///< V at the terminals, which the machine holds
    double speed = 0.1;  ///< m/s of wire
    WireMelting melting;
    double meltingEnergy =
        0; ///< J of electric energy that melt a metre of wire, heat that is lost included; 0: unknown
};

/// One wire on one machine. Between steps it keeps the extension and whether an arc burns.
class WireArc {
  public:
    explicit WireArc(double extension = 0) : extension_(extension) {}

    /// Goes on by `seconds` with the metal `distance` (m) from the contact tip, infinite where there is none, while the
    /// wire is fed. The current follows from arc = distance - extension = (U - V0 - R I)/E and d(extension)/dt = feed -
    /// melting, solved implicitly at the step's end, as their time constants are as short as the step. No more wire
    /// melts than the electric power can melt; the rest stands out. A contact tip on the metal lets no wire through.
    void step(const WireFeed& feed, double distance, double seconds);
    /// The wire stands still and the arc is out.
    void release();

    /// Saves or restores it.
    void transfer(gl::StateArchive& archive);

    ArcAction action() const { return action_; }
    NoArc noArc() const { return noArc_; }          ///< why action() is `out`
    double extension() const { return extension_; } ///< m; more than the distance: the wire is bent
    double length() const { return length_; }       ///< m, of the arc
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

/// A that an open arc takes where the wire's end is `length` (m) from the metal: (U - V0 - E length)/R, not below 0 nor
/// above the machine's short circuit.
double openArcCurrent(const WireFeed& feed, double length);

/// Length (m) at which an open arc goes out.
double longestWireArc(const WireFeed& feed);

} // namespace meltpool
