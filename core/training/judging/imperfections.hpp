// The imperfections of a weld that acceptance files name, and which figures of a station tell of each.
#pragma once

#include "core/weld/gauge/weld_stations.hpp"

namespace meltpool {

/// What the weld was to be. Lengths in m.
struct NominalWeld {
    double thickness = 0; ///< t, of the thinner plate
    /// a, nominal throat, and the nominal leg of a fillet. One of them is enough: a = leg / sqrt(2). A butt's throat is
    /// its plates' thickness where none is given.
    std::optional<double> throat, leg;
    double platesOffset = 0; ///< of a butt's plates against each other, as the workpiece was set up
    double jointGap = 0;     ///< under a fillet, as the workpiece was set up

    std::optional<double> throatOf(WeldKind kind) const;
    std::optional<double> legOf() const;
};

/// What a station says of an imperfection.
struct ImperfectionValue {
    double value = 0; ///< in the imperfection's unit; may be negative where the weld is on the safe side
    double width = 0; ///< b, mm: of the reinforcement, the fillet's face or the root that the limit may grow with
};

/// One imperfection.
struct Imperfection {
    std::string_view name; ///< in acceptance files and results
    std::string_view unit; ///< "mm" or "deg"
    /// How much of it the particles resolve, in spacings; of angles see kResolvedAngle. 0: a yes or no that the
    /// metal itself answers.
    double resolution = 0;
    /// What a station tells; nothing where it cannot. Null for what the metal does not contain.
    std::optional<ImperfectionValue> (*measure)(const WeldStation&, const NominalWeld&, WeldKind) = nullptr;
};

/// All of them: lengths of what is missing or too much in mm, the toe angle in degrees outside the weld metal between
/// plate and weld surface (ISO 5817: 180 less the edge angle).
std::span<const Imperfection> imperfections();

/// Null for an unknown name.
const Imperfection* findImperfection(std::string_view name);

/// Half a spacing: what the gauge resolves of a length.
inline constexpr double kResolvedSpacings = 0.5;

/// Degrees of a toe angle that particles resolve: five layers of them scatter by as much about the angle that they
/// stand for (tests/weld/gauge/weld_shape_test.cpp, disordered particles).
inline constexpr double kResolvedAngle = 15;

} // namespace meltpool
