// The table of shielding gases, and the arcs and settings that follow from it.
#include "core/base/error.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/process/shielding_gas.hpp"
#include "core/weld/process/weld_constants.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cmath>
#include <set>

using namespace meltpool;

namespace {

constexpr double kStep = 1.0 / 109;

ProcessSettings gmaw(GasKind gas) {
    ProcessSettings settings;
    settings.choose<Gmaw>() = {30, 6, 1.2F, 1, 12, static_cast<int>(gas)};
    return settings;
}

/// Returns the settled arc of these settings, 16 mm over a plate.
ArcState settled(const ProcessSettings& settings) {
    static const HeatTable table(
        readMaterial(test::testFolder().parent_path() / "app" / "data" / "materials" / "s235.toml"));
    const auto process = makeProcess(settings, {table, 7850, 1e-3F, 293.15});
    TorchSample torch;
    torch.trigger = 1;
    for (int i = 0; i < 400; ++i)
        process->step(torch, {16e-3F, 0}, kStep);
    return process->arc();
}

} // namespace

TEST_CASE("each gas has a name of its own, and the mix of the fitted constants changes nothing", "[weld][gas]") {
    std::set<std::string_view> names;
    for (size_t i = 0; i < shieldingGases().size(); ++i) {
        const ShieldingGas& gas = shieldingGases()[i];
        CHECK(gas.name == shieldingGasNames()[i]);
        CHECK(findShieldingGas(gas.name) == &gas);
        CHECK(&shieldingGas(static_cast<GasKind>(i)) == &gas);
        names.insert(gas.name);
    }
    CHECK(names.size() == 5);
    CHECK(findShieldingGas("helium") == nullptr);
    const ShieldingGas& mix = shieldingGas(GasKind::arCo2);
    CHECK(mix.arcVoltage == 0);
    CHECK(mix.spatter == 1);
    CHECK(mix.sprayCurrent == kSprayCurrent);
    CHECK(GmawSettings{}.gas == static_cast<int>(GasKind::arCo2));
}

TEST_CASE("no wire sprays in carbon dioxide, and argon with oxygen sprays first", "[weld][gas]") {
    const auto share = [](double current, GasKind gas) { return sprayShare(current, 1, shieldingGas(gas)); };
    CHECK(share(1000, GasKind::co2) == 0);
    CHECK(share(1000, GasKind::none) == 0);
    CHECK(share(198, GasKind::arO2) == 1);
    CHECK(share(198, GasKind::arCo2) == 0);
    CHECK(share(198, GasKind::ar) < share(198, GasKind::arO2));
    // A maker's table for 98 % argon, 2 % oxygen: least current of spray for each wire.
    for (const auto& [diameter, current] : {std::pair(0.76, 150), {0.89, 165}, {1.1, 220}, {1.3, 240}, {1.6, 275}})
        CHECK(*shieldingGas(GasKind::arO2).sprayCurrent * std::pow(diameter, kSprayExponent) ==
              Approx(current).epsilon(0.065));
}

TEST_CASE("an arc in carbon dioxide is shorter at equal voltage and feed, and equally long with 1.5 V more",
          "[weld][gas]") {
    const ArcState mix = settled(gmaw(GasKind::arCo2)), co2 = settled(gmaw(GasKind::co2));
    REQUIRE(mix.action == ArcAction::burning);
    REQUIRE(co2.action == ArcAction::burning);
    CHECK(co2.length < mix.length - 1e-3F);
    ProcessSettings raised = gmaw(GasKind::co2);
    raised.of<Gmaw>().voltage += 1.5F;
    const ArcState same = settled(raised);
    CHECK(same.length == Approx(mix.length).epsilon(1e-4));
    CHECK(same.current == Approx(mix.current).epsilon(1e-4));
    // A dipping wire leaves the pool at a higher voltage in carbon dioxide.
    ProcessSettings dips = gmaw(GasKind::co2);
    dips.of<Gmaw>().voltage = 22;
    CHECK(settled(dips).action == ArcAction::shorting);
    dips.of<Gmaw>().gas = static_cast<int>(GasKind::arO2);
    CHECK(settled(dips).action == ArcAction::burning);
}

TEST_CASE("equipment tells the gas: chosen for a wire, argon for tungsten, none for others", "[weld][gas]") {
    ProcessSettings settings = gmaw(GasKind::co2);
    settings.of<Gmaw>().gasFlowLMin = 9;
    const Equipment wire = equipmentOf(settings);
    CHECK(wire.gas == &shieldingGas(GasKind::co2));
    CHECK(wire.gasFlow == 9);
    CHECK(wire.spatter > equipmentOf(gmaw(GasKind::arCo2)).spatter);
    for (size_t kind = 0; kind < AllProcesses::kCount; ++kind) {
        settings.kind = static_cast<int>(kind);
        INFO(traitsOf(settings).name);
        CHECK((equipmentOf(settings).gas != nullptr) == (traitsOf(settings).shielding == Shielding::gas));
    }
    settings.choose<Gtaw>();
    CHECK(equipmentOf(settings).gas == &shieldingGas(GasKind::ar));
    CHECK_THROWS_WITH(setParameter(describe(settings), "gas", "co2", "lesson.toml:9"),
                      test::containsText("lesson.toml:9: 'gas' is 'co2'; expected one of ar"));
    settings.choose<Gmaw>();
    CHECK_THROWS_WITH(setParameter(describe(settings), "gas", "helium", "lesson.toml:9"),
                      test::containsText("expected one of ar_co2, co2, ar_o2, ar, none"));
}
