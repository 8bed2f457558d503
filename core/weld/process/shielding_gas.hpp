// Table of the gases that wire and tungsten arcs burn in, with the differences that each makes to the arc.
//
// Marks: R read in the source, M trade knowledge that no opened source confirmed, I inferred. The mix of argon and
// carbon dioxide is the gas in which the constants of weld_constants.hpp hold, so its row changes nothing. No source
// gives a number for the shape of the penetration (argon digs a narrow finger, carbon dioxide a wide bowl), nor for the
// heat: both are those of the mix in every gas.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace meltpool {

/// Index in shieldingGases() and in shieldingGasNames().
enum class GasKind { arCo2, co2, arO2, ar, none };

struct ShieldingGas {
    std::string_view name{}; ///< name in lessons, records, results and charts
    /// V by which an arc of equal length and current burns higher than in the mix of argon and carbon dioxide.
    double arcVoltage = 0;
    /// A above which a wire of 1 mm sprays, see kSprayExponent for others; none: large drops fall at any current.
    std::optional<double> sprayCurrent{};
    double spatter = 1; ///< times the drops that an open arc throws in the mix, see Equipment::spatter
};

/// Returns the gases in the order of GasKind.
std::span<const ShieldingGas> shieldingGases();
const ShieldingGas& shieldingGas(GasKind kind);
/// Returns their names in the order of GasKind: "ar_co2", "co2" ...
std::span<const std::string_view> shieldingGasNames();
/// Returns the gas of this name; null if there is none.
const ShieldingGas* findShieldingGas(std::string_view name);
/// Returns the name of a gas for people, in the chosen language.
std::string_view gasText(const ShieldingGas& gas);

/// L/min of gas for each millimetre of the wire's diameter that a maker recommends for carbon steel (ESAB Warrior 750i,
/// manual 0463 730 001, p. 24; R). Panasonic's charts have 10 to 15 L/min for wires of 0.4 to 1.2 mm (YD-350GL4, p. 52;
/// R).
inline constexpr double kGasFlowPerMm = 10;
/// Share of the recommended flow below which air reaches the pool. No source gives a number: chosen here.
inline constexpr double kLeastGasShare = 0.75;

} // namespace meltpool
