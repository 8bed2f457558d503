#include "core/weld/process/shielding_gas.hpp"

#include "core/base/words.hpp"
#include "core/weld/process/weld_constants.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 5> kNames{"ar_co2", "co2", "ar_o2", "ar", "none"};

constexpr std::array<ShieldingGas, kNames.size()> kGases{{
    // 18 to 25 % of carbon dioxide. The logged beads, on which the arc was fitted, do not name their gas: taken to be
    // this one (I), the usual one for such a wire.
    {.name = kNames[0], .sprayCurrent = kSprayCurrent},
    // Charts of dip transfer in carbon dioxide have 1 to 2 V more than those in 75 % argon (footnote in Lincoln's data
    // sheet of SuperArc L-56; R). Above some 20 % of it no wire sprays (M). The number of drops is chosen: "medium
    // spatter" in dip, "spattery" when globular (a gas dealer's table; R, without numbers).
    {.name = kNames[1], .arcVoltage = 1.5, .spatter = 2},
    // 98 % argon, 2 % oxygen. The spray current is the mean of a maker's table from 0.76 to 1.6 mm (ESAB MIG handbook,
    // table 1-2; R), brought to 1 mm by kSprayExponent. The voltage is chosen (M: a volt or two below the mix).
    {.name = kNames[2], .arcVoltage = -1.5, .sprayCurrent = 190, .spatter = 0.5},
    // Oxygen lowers the spray current (a gas dealer's page; R, without a number): 10 A more than with it, chosen. The
    // voltage is chosen. Its arc on steel wanders (R), which here only its spatter shows.
    {.name = kNames[3], .arcVoltage = -1.5, .sprayCurrent = 200},
    // Air. No source gives the arc of a solid wire in it: as in carbon dioxide, the other gas of molecules that the arc
    // must part (I). Its pores are estimated, see estimateImperfections().
    {.name = kNames[4], .arcVoltage = 1.5, .spatter = 3},
}};

} // namespace

std::span<const ShieldingGas> shieldingGases() {
    return kGases;
}

const ShieldingGas& shieldingGas(GasKind kind) {
    return kGases[static_cast<size_t>(kind)];
}

std::span<const std::string_view> shieldingGasNames() {
    return kNames;
}

const ShieldingGas* findShieldingGas(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    return found == kNames.end() ? nullptr : &kGases[static_cast<size_t>(found - kNames.begin())];
}

std::string_view gasText(const ShieldingGas& gas) {
    return phraseOr(ShortText{"parameter.gas.choice.", gas.name}, gas.name);
}

} // namespace meltpool
