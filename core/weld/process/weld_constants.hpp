// Constants of the arc welding processes, other than the metal's own: unit, meaning, and source or fit of each. Lessons
// and validation weld with these.
//
// "Fitted on A" means the logged beads (tests/validation/logged). Six of them (B008, B012, B014, B018, B022, B030) set
// the values of wetting, of stirring and of spray's radius; four others (B002, B006, B016, B020) served earlier fits.
// All fifteen were known during the fit, so none of them is a prediction. "Fitted on B" is Park's bead
// (tests/validation/cases/bead_gmaw_park.toml), with an arc of 5 mm, which is 3.6 mm with the present constants.
// "Fitted on C" are the nine other arc beads there. The vendor's fillet PANF-4 and the lesson tee-fillet were known
// during the fit, too; the replicated, clad, other vendors' and pyrometer's welds were not. "Fitted on D" means the
// four welds of makers' charts in tests/validation/charts at their middle voltages and at 4 V less; these were known.
#pragma once

namespace meltpool {

// The wire of GMAW: it melts at alpha I + beta s I² with the extension s (Lesnewich 1958; Halmoy 1979), see
// WireMelting.

/// m, diameter of the wire for which the next two hold; others scale by the cross-section.
inline constexpr double kReferenceWire = 1.2e-3;
/// m/(A s), melting by the arc's heat. Fitted on A; the classic value for steel is 0.30e-3.
inline constexpr double kReferenceAlpha = 0.28e-3;
/// 1/(A² s), melting by the wire's resistance. Fitted on A; the classic value for steel is 5e-5.
inline constexpr double kReferenceBeta = 6.3e-5;

// The circuit of GMAW: U = V0 + E L + R I.

/// V, the falls at the arc's ends. Control literature for 1.0 mm steel wire; no document was checked.
inline constexpr double kArcFallVoltage = 15.7;
/// V/m along the column of the arc. Fitted on A; control literature has 640 for 1.0 mm steel wire.
inline constexpr double kArcField = 1000;
/// Ohm of the wire's extension and its contact. Control literature; no document was checked.
inline constexpr double kWireResistance = 0.026;
/// A, most that the machine delivers into a short circuit. A machine of the 500 A class; no document was checked.
inline constexpr double kShortCircuitCurrent = 600;
/// m from the contact tip to the metal below which the wire cannot come out. No source: chosen.
inline constexpr double kBlockedTip = 1e-3;
/// A below which an arc between steel and a thin wire does not hold. Trade knowledge; no document was checked.
inline constexpr double kLeastArcCurrent = 20;
/// Share of the arc's own voltage, on average, below which the wire of an ordinary machine stays in the metal. No
/// source: chosen.
inline constexpr double kStubShare = 0.6;
/// A that flow when a machine with controlled short circuits opens one. A maker's data sheet of such a machine: 45
/// to 50.
inline constexpr double kControlledBreakCurrent = 50;
/// s in which a dipping wire follows the metal that rises or falls under it: some of its 20 to 200 short circuits a
/// second. No source: chosen.
inline constexpr double kDipTime = 0.05;
/// m that the metal may fall away from a dipping wire before its arc counts as open: an arc of such a length on the
/// voltage of dip transfer goes out. No source: chosen.
inline constexpr double kLongestDipArc = 3e-3;

// Heat of the arcs.

/// Share of GTAW's electric power that reaches the metal. Calorimetry of several authors, 0.73 to 0.82. Not the factor
/// of EN 1011-1, which is for procedure sheets.
inline constexpr double kGtawEfficiency = 0.77;
/// Share of GMAW's electric power that reaches the metal. Calorimetry of several authors, 0.84 to 0.85.
inline constexpr double kGmawEfficiency = 0.85;
/// K, temperature of drops that leave the wire: 2200 °C; measurements are between 2000 and 2600 °C.
inline constexpr double kDropTemperature = 2473.15;
/// K, temperature of drops that a dipping wire leaves in the pool: measurements are between 1900 and 2300 K; no
/// document was checked. Fitted on D.
inline constexpr double kDipDropTemperature = 2100;
/// Wire diameters, drop of a wire that does not spray; it decides how often the drop bridges the arc, see
/// Gmaw::shortsLeft(). Drawings of welding handbooks.
inline constexpr double kGlobularDrop = 2;
/// m/s of drops that leave the wire in dip and globular transfer. High-speed films of both.
inline constexpr float kDropSpeed = 0.3F;
/// m/s of drops that leave the wire in spray, driven by the plasma jet. No source: chosen. Trade knowledge, 1 to 3 m/s;
/// no document was checked, and liquid steel of 1 mm particles flies at 1.1 m/s at most.
inline constexpr float kSprayDropSpeed = 1.0F;
/// Times the radius of heat measured on copper anodes with GTAW, see arcHeatRadius(). Fitted on B: GMAW arcs are
/// narrower.
inline constexpr double kArcSpread = 0.45;
/// m, shortest length in the arc's spread: a shorter arc spreads its heat as one of this length, the mean length in dip
/// transfer. Fitted on A.
inline constexpr double kShortestSpread = 0.5e-3;
/// m, radius of heat of GMAW in spray transfer, whose arc envelops the wire's end, at any arc length, at the current
/// below. Fitted on A and C; 0.53 mm (I/A)^0.294, as measured on copper anodes with GTAW, gives 2.6 mm there.
inline constexpr double kSprayRadius = 2.8e-3;
/// Current (A) at which kSprayRadius holds.
inline constexpr double kSprayRadiusCurrent = 235;
/// Power of the current in the radius: more current pinches the arc and digs its end into the metal. Fitted on A and C,
/// from 220 to 475 A.
inline constexpr double kSprayRadiusExponent = -0.3;
/// m, radius of spray's pressure, at any arc length: the jet from the wire's end is narrower than the arc around it.
/// Fitted on C, which penetrates deeper with more voltage: a longer arc does not press more widely there.
inline constexpr double kSprayPressureRadius = 1.8e-3;
/// A above which a wire of 1 mm sprays: the logged beads' machine changes from dip to spray there.
inline constexpr double kSprayCurrent = 207;
/// Power of the wire's diameter in this current. Table of a maker of wires for 98 % argon, 2 % oxygen: 165 A for 0.89
/// mm to 275 A for 1.6 mm.
inline constexpr double kSprayExponent = 0.87;
/// Share of the spray current: range about it over which the transfer changes. No source: chosen.
inline constexpr double kSprayRange = 0.08;
/// A of arc for which stirring adds the liquid's own conductivity once more, see arcStirring(). Fitted on B and C.
inline constexpr double kStirringCurrent = 45;

/// Share of the arc's highest pressure: highest drag of its plasma jet along the metal, 2.1 sigmas of the pressure from
/// the axis. A laminar jet gives 1.8 over the root of its Reynolds number, 0.1 to 0.2 for the 100 to 300 of arcs
/// (Phares, Smedley and Flagan 2000; no document was checked), a turbulent one 0.006. It moves the width of B012, B018
/// and B030 by 2 % at most.
inline constexpr double kJetDrag = 0.1;

// Stirring by surface tension in a process without wire through the arc (GTAW), see pulledStirring().

/// Share of the way from the liquidus to the boiling point: temperature of the surface half-way from the pool's edge to
/// the arc, 2100 K in steel. Spectra of such pools have 2200 to 2700 K under the arc; no document was checked. The flow
/// of steel turns with 0.009 % of sulphur then; measured ones did with 0.004 to 0.008 % (Mills and Keene 1990; not
/// checked).
inline constexpr double kHalfWayToArc = 0.225;
/// N/m of pull that leads the heat wholly. No source: chosen; clean iron has 0.13.
inline constexpr double kWholePull = 0.08;
/// Share of the stirred conductivity that is left against the flow. No source: chosen; pools change no more below it.
/// Sulphur makes depth over width 1.6 times as large with it; surface-active oxygen doubled that of stainless steel
/// (Lu, Fujii and Nogi 2009).
inline constexpr double kLeastStirring = 0.2;

// The filler rod of GTAW. These have no source; they are chosen by descriptions of welders.

/// Share of the arc's heat that melts a rod dipped into the pool, at most.
inline constexpr double kRodPoolShare = 0.5;
/// Share of the arc's heat that melts a rod held in the arc above the pool.
inline constexpr double kRodArcShare = 0.3;
/// Diameter, in rod diameters, that a ball on its end reaches before it falls.
inline constexpr double kRodBall = 1.5;

// The covered electrode (SMAW).

/// Share of SMAW's electric power that reaches the metal. Calorimetry of several authors, 0.66 to 0.85; no document was
/// checked.
inline constexpr double kSmawEfficiency = 0.75;
/// Share of the melted core that reaches the weld: an E7018 of 3.15 mm leaves 18 g of some 19 g that melt.
inline constexpr double kSmawDeposit = 0.95;
/// V/m along the arc's column. Trade knowledge, 1 to 2 V/mm; no document was checked.
inline constexpr double kSmawField = 1500;
/// V/A by which its arc's voltage grows with the current. No source: chosen.
inline constexpr double kSmawResistance = 0.03;
/// V and V/A of a stick machine's load line (IEC 60974-1).
inline constexpr double kSmawLoadVoltage = 20;
inline constexpr double kSmawLoadSlope = 0.04;
/// Times the load line, at which the arc goes out. No source: chosen; it puts the end of an arc of 115 A at some 9 mm.
inline constexpr double kSmawReserve = 1.35;
/// Times the set current that flows while the electrode touches. Machines with arc force give 1.2 to 1.5; no document
/// was checked.
inline constexpr double kSmawTouchCurrent = 1.3;
/// V across the touching electrode. No source: chosen.
inline constexpr double kSmawTouchVoltage = 5;
/// s of touch after which the electrode sticks. Trade knowledge; no document was checked.
inline constexpr double kSmawSticks = 0.3;
/// rad that a stuck electrode must be twisted or bent to come free: 12 degrees. No source: chosen.
inline constexpr double kSmawFrees = 0.21;
/// m off the metal at which a pull has torn a stuck electrode loose. No source: chosen, farther than rod, hand and
/// plate give way.
inline constexpr double kSmawTears = 15e-3;
/// m of gap that an arc jumps when the electrode is lifted off. No source: chosen.
inline constexpr double kSmawLift = 4e-3;
/// m of electrode that remain as the stub.
inline constexpr double kSmawStub = 0.05;

// Wetting of still metal by liquid metal of its own kind. Liquid that reaches cold metal freezes at the line of
// contact, which stops (Schiaffino and Sonin 1997); it runs on over metal so hot that it does not freeze there.

/// Degrees, contact angle on cold metal, see wettingForAngle(). Fitted on A.
inline constexpr double kColdAngle = 130;
/// Share of the solidus in K: all metal up to here is cold. Fitted on A, with B008, B012, B014, B022 and B030.
inline constexpr double kColdShare = 0.65;
/// Share of the solidus in K: metal from here on is wetted wholly; in between in part, as the angle at which a line of
/// contact freezes falls with the metal's warmth. Fitted with kColdShare.
inline constexpr double kWarmShare = 0.85;

// A dipping wire whose arc burns nearly all the time warms the plates before the pool's edge, and each short circuit
// shakes the pool: its edge runs on farther before it freezes. (Drops that are driven spread farther than such that are
// laid down: Chapuis et al. 2013; no document was checked.) The less the arc burns between short circuits, the more the
// constants above hold. An arc that stays open, tungsten arcs and covered electrodes keep those.

/// Share of the time, see arcTime(), up to which the constants above hold for a dipping wire. All logged beads that dip
/// have less, 0.63 to 0.79.
inline constexpr double kColdArcTime = 0.8;
/// Share from which the edge runs on. Charts of dip transfer have 0.89 to 1 in the middle. No source: chosen.
inline constexpr double kFullArcTime = 0.95;
/// kColdAngle, kColdShare and kWarmShare with an arc of kFullArcTime: 30 degrees for each unit of the Stefan number,
/// heat capacity times solidus less temperature over latent heat, by which the angle of freezing drops goes (Schiaffino
/// and Sonin 1997; the factor is fitted on D). Of steel that is 0.08 degrees a kelvin, here from the solidus to 125
/// degrees.
inline constexpr double kStefanAngle = 125;
inline constexpr double kStefanColdShare = 0.11;
inline constexpr double kStefanWarmShare = 1;

} // namespace meltpool
