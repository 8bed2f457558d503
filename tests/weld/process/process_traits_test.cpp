// Traits of the processes: complete, and consistent with each other and with the settings.
#include "core/weld/process/processes.hpp"
#include "tests/support/catch.hpp"

#include <set>

using namespace meltpool;

namespace {

template <class P>
Equipment equipment() {
    ProcessSettings settings;
    settings.choose<P>();
    return equipmentOf(settings);
}

} // namespace

TEST_CASE("each process has a name of its own") {
    std::set<std::string_view> names;
    ProcessSettings settings;
    for (size_t kind = 0; kind < AllProcesses::kCount; ++kind) {
        settings.kind = static_cast<int>(kind);
        const ProcessTraits& traits = traitsOf(settings);
        CHECK(traits.name == AllProcesses::kNames[kind]);
        names.insert(traits.name);
    }
    CHECK(names.size() == AllProcesses::kCount);
}

TEST_CASE("an arc strikes, sounds, has a cover and a heat input; a process without one has none of these") {
    ProcessSettings settings;
    for (size_t kind = 0; kind < AllProcesses::kCount; ++kind) {
        settings.kind = static_cast<int>(kind);
        const ProcessTraits& traits = traitsOf(settings);
        const bool arc = traits.arc;
        INFO(traits.name);
        CHECK((traits.striking != Striking::none) == arc);
        CHECK((traits.shielding != Shielding::none) == arc);
        CHECK((traits.sound.loud > traits.sound.quiet) == arc);
        CHECK((traits.sound.highPitch > traits.sound.lowPitch) == arc);
        CHECK((traits.sound.postFlow > 0) == (traits.shielding == Shielding::gas));
        CHECK(traits.efficiency.has_value() == arc);
    }
    CHECK((Gmaw::kTraits.arc && Gtaw::kTraits.arc && Smaw::kTraits.arc));
    CHECK_FALSE((Flame::kTraits.arc || SolderingIron::kTraits.arc));
    CHECK(Gtaw::kTraits.efficiency == 0.6); // EN 1011-1, table
    CHECK(Gmaw::kTraits.efficiency == 0.8);
    CHECK(Smaw::kTraits.efficiency == 0.8);
    CHECK(Flame::kTraits.sound.roar > 0);
}

TEST_CASE("a process that feeds wire has one, a rod is what the other hand holds, an electrode has its core") {
    ProcessSettings settings;
    for (size_t kind = 0; kind < AllProcesses::kCount; ++kind) {
        settings.kind = static_cast<int>(kind);
        const Equipment tools = equipmentOf(settings);
        INFO(traitsOf(settings).name);
        CHECK((tools.wire > 0) == traitsOf(settings).feedsWire);
        CHECK((tools.heldBehind > 0) == traitsOf(settings).feedsWire);
        CHECK((tools.electrode > 0) == (traitsOf(settings).shielding == Shielding::slag));
        CHECK((tools.electrodeLength > 0) == (tools.electrode > 0));
        CHECK((tools.wireRate() > 0) == (tools.wire > 0));
        CHECK((tools.spatter > 0) == (tools.wire > 0 || tools.electrode > 0));
        CHECK((tools.spatter > 0) == (traitsOf(settings).fume > 0));
    }
    settings.choose<Gmaw>() = {20, 6, 1.2F};
    CHECK(equipmentOf(settings).wireRate() == Approx(0.1131e-6).epsilon(1e-3)); // m³/s
    CHECK(equipment<Gtaw>().rod == Approx(2.4e-3));
    CHECK(equipment<SolderingIron>().rod == 0);
}

TEST_CASE("a cellulosic electrode spatters more than the others") {
    ProcessSettings settings;
    SmawSettings& smaw = settings.choose<Smaw>();
    const double rutile = equipmentOf(settings).spatter;
    smaw.electrode = 1;
    CHECK(equipmentOf(settings).spatter == rutile);
    smaw.electrode = 2;
    REQUIRE(smawElectrodes()[2] == "e6010");
    CHECK(equipmentOf(settings).spatter == 2 * rutile);
}

TEST_CASE("the machine shows what is set on it, first things first; a flame has no machine") {
    ProcessSettings settings;
    settings.choose<Gmaw>() = {23.5F, 7, 1.0F};
    CHECK(equipmentOf(settings).displays[0] == MachineDisplay{23.5F, "v", 1});
    CHECK(equipmentOf(settings).displays[1] == MachineDisplay{7, "m/min", 1});
    settings.choose<Smaw>().current = 140;
    CHECK(equipmentOf(settings).displays[0] == MachineDisplay{140, "a", 0});
    CHECK(equipmentOf(settings).displays[1].unit.empty());
    CHECK_FALSE(equipment<SolderingIron>().displays[0].unit.empty());
    CHECK(equipment<Flame>().displays[0].unit.empty());
}

TEST_CASE("an earlier edition's name of a process is known, and no other") {
    CHECK(presentProcessName("tig") == "gtaw");
    CHECK(presentProcessName("gmaw") == "gmaw");
    CHECK(presentProcessName("") == "");
    CHECK(presentProcessName("laser") == "laser");
}
