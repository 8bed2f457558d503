// Each process as in lessons: its settings, its burning conditions, and its balance of heat and wire.
#include "core/weld/process/processes.hpp"
#include "core/weld/process/weld_constants.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <limits>
#include <set>

using namespace meltpool;

namespace {

constexpr double kStep = 1.0 / 109;

Material steel() {
    return readMaterial(test::testFolder().parent_path() / "app" / "data" / "materials" / "s235.toml");
}

const HeatTable& table() {
    static const HeatTable made(steel());
    return made;
}

std::unique_ptr<Process> made(const ProcessSettings& settings) {
    return makeProcess(settings, {table(), 7850, 1e-3F, 293.15});
}

TorchSample pulled(float trigger = 1) {
    TorchSample torch;
    torch.tip = {0, 0.002F, 0};
    torch.orientation = glm::angleAxis(-1.5707963F, glm::vec3(1, 0, 0));
    torch.trigger = trigger;
    return torch;
}

MetalAhead metalAt(double mm, float liquid = 0) {
    return {static_cast<float>(mm * 1e-3), liquid};
}

/// Returns the heat (J) of a drop above wire at room temperature.
double dropHeat(const MetalSeed& drop) {
    return 7850e-9 * (table().enthalpyAt(double(drop.temperature)) - table().enthalpyAt(293.15));
}

ArcAction after(Process& process, double mm, float trigger = 1) {
    process.step(pulled(trigger), metalAt(mm), kStep);
    return process.arc().action;
}

NoArc whyNoArc(Process& process, double mm, float trigger) {
    const bool out = after(process, mm, trigger) == ArcAction::out;
    CHECK(out == (process.arc().noArc != NoArc::burns));
    return process.arc().noArc;
}

constexpr double kNowhere = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("only the settings of the chosen process are described, and each is in its range") {
    ProcessSettings settings;
    for (size_t kind = 0; kind < AllProcesses::kCount; ++kind) {
        settings.kind = static_cast<int>(kind);
        const ParameterList list = describe(settings);
        CHECK(list.front().key == "process");
        CHECK(parameterText(list.front()) == AllProcesses::kNames[kind]);
        CHECK((findParameter(list, "wire_feed_m_min") != nullptr) == settings.is<Gmaw>());
        CHECK((findParameter(list, "current") != nullptr) == (settings.is<Gtaw>() || settings.is<Smaw>()));
        CHECK((findParameter(list, "flame_power") != nullptr) == settings.is<Flame>());
        for (const Parameter& parameter : list) // a default must be permitted
            CHECK_NOTHROW(setParameter(list, parameter.key, parameterText(parameter), "default"));
    }
}

TEST_CASE("a setting that a process had once is named with its successor") {
    ProcessSettings settings;
    settings.choose<Gmaw>();
    CHECK(successorOf(settings, "current").find("wire_feed_m_min") != std::string_view::npos);
    CHECK(successorOf(settings, "voltage").empty());
    settings.choose<Gtaw>();
    CHECK_FALSE(successorOf(settings, "voltage").empty());
    CHECK(successorOf(settings, "nonsense").empty());
}

namespace {

/// Returns a GMAW arc over metal 15 mm from the contact tip that has found its length, with its last drops' heat.
std::unique_ptr<Process> settledGmaw(float voltage, float feedMPerMin,
                                     ShortCircuitKind shorts = ShortCircuitKind::ordinary) {
    ProcessSettings settings;
    GmawSettings& gmaw = settings.choose<Gmaw>();
    gmaw.voltage = voltage;
    gmaw.wireFeedMPerMin = feedMPerMin;
    gmaw.wireDiameterMm = 1.2F;
    gmaw.stickOutMm = 14;
    gmaw.shortCircuits = static_cast<int>(shorts);
    auto process = made(settings);
    for (int i = 0; i < 300; ++i)
        process->step(pulled(), metalAt(15), kStep);
    return process;
}

/// Returns the temperature of the next drop of such an arc, K.
double nextDrop(Process& process) {
    for (int i = 0; i < 100; ++i) {
        process.step(pulled(), metalAt(15), kStep);
        if (!process.drops().empty()) return static_cast<double>(process.drops()[0].temperature);
    }
    return 0;
}

} // namespace

TEST_CASE("the longer a dipping wire's arc burns, the farther the pool's edge runs on over cold metal, until the arc "
          "stays open") {
    const EdgeArrest cold = settledGmaw(15, 3.6F)->edgeArrest();
    CHECK(cold.coldAngle == Approx(kColdAngle * 3.14159265 / 180));
    CHECK(cold.coldShare == kColdShare);
    CHECK(cold.warmShare == kWarmShare);
    const EdgeArrest dips = settledGmaw(19.6F, 3.6F)->edgeArrest();
    CHECK(dips.coldShare == Approx(kStefanColdShare).margin(0.01));
    CHECK(dips.warmShare == Approx(kStefanWarmShare).margin(0.01));
    CHECK(dips.coldAngle == Approx(kStefanAngle * 3.14159265 / 180).margin(0.02));
    const EdgeArrest between = settledGmaw(17.4F, 3.6F)->edgeArrest();
    CHECK(between.coldShare < kColdShare - 0.01);
    CHECK(between.coldShare > kStefanColdShare + 0.01);
    // An arc that stays open: long, and spraying.
    for (const auto& [voltage, feed] : {std::pair(29.0F, 3.6F), {28.0F, 11.0F}}) {
        const EdgeArrest arc = settledGmaw(voltage, feed)->edgeArrest();
        CHECK(arc.coldShare == Approx(kColdShare).margin(0.001));
        CHECK(arc.warmShare == Approx(kWarmShare).margin(0.001));
    }
    // In between a longer arc dips more seldom.
    CHECK(settledGmaw(22, 3.6F)->edgeArrest().coldShare < settledGmaw(24, 3.6F)->edgeArrest().coldShare - 0.01);
}

TEST_CASE("a machine that controls the wire's short circuits makes them at its own rate, and lets no wire stub") {
    const auto ordinary = settledGmaw(11, 3.6F), controlled = settledGmaw(11, 3.6F, ShortCircuitKind::controlled);
    CHECK(ordinary->arc().action == ArcAction::stubbed);
    CHECK(controlled->arc().action == ArcAction::shorting);
    CHECK(controlled->arc().shorts == 70);
    CHECK(settledGmaw(18, 3.6F)->arc().shorts == 120);
    // The longer the arc, the fewer; a spraying one has none.
    const float few = settledGmaw(21, 3.6F)->arc().shorts;
    CHECK(few > 1);
    CHECK(few < 110);
    CHECK(settledGmaw(28, 11)->arc().shorts == 0);
    CHECK(findShortCircuits("controlled") == ShortCircuitKind::controlled);
    CHECK_FALSE(findShortCircuits("cold"));
}

TEST_CASE("the drops of a dipping wire are colder than those of an open arc") {
    CHECK(nextDrop(*settledGmaw(18, 3.6F)) == Approx(kDipDropTemperature).epsilon(0.001));
    CHECK(nextDrop(*settledGmaw(26, 3.6F)) == Approx(kDropTemperature).epsilon(0.001));
    CHECK(nextDrop(*settledGmaw(28, 11)) == Approx(kDropTemperature).epsilon(0.001));
}

TEST_CASE("without the trigger no process gives heat, wire or pressure") {
    ProcessSettings settings;
    for (size_t kind = 0; kind < AllProcesses::kCount; ++kind) {
        settings.kind = static_cast<int>(kind);
        const auto process = made(settings);
        CHECK(after(*process, 2, 0) == ArcAction::out);
        CHECK(process->sources().empty());
        CHECK(process->drops().empty());
        CHECK(process->pressure().peak == 0);
    }
}

TEST_CASE("a GTAW arc strikes near the metal, follows its length and goes out when it is too long") {
    ProcessSettings settings;
    settings.choose<Gtaw>().current = 130;
    const auto process = made(settings);
    CHECK(after(*process, 8) == ArcAction::out); // too far for the spark
    CHECK(after(*process, 3) == ArcAction::striking);
    CHECK(process->arc().voltage == Approx(gtawVoltage(3e-3, 130)));
    double power = process->arc().power;
    for (const double mm : {3.0, 4.0, 5.0}) {
        CHECK(after(*process, mm) == ArcAction::burning);
        CHECK(process->arc().current == 130);
        CHECK(process->arc().power >= power);
        CHECK(double(process->sources()[0].power) == Approx(process->arc().power));
        power = process->arc().power;
    }
    CHECK(after(*process, 7) == ArcAction::breaking);
    CHECK(after(*process, 1e3 * gtawLongestArc(130) + 0.5) == ArcAction::out);
    CHECK(process->sources().empty());
    CHECK(after(*process, 3) == ArcAction::out); // the trigger is still pulled
    CHECK(after(*process, 3, 0) == ArcAction::out);
    CHECK(after(*process, 3) == ArcAction::striking);
    CHECK(after(*process, 3, 0.5F) == ArcAction::burning);
    CHECK(process->arc().current == 65);
}

TEST_CASE("a GTAW torch says why it has no arc: why it went out, and why it does not strike") {
    ProcessSettings settings;
    settings.choose<Gtaw>().current = 130;
    const auto process = made(settings);
    const auto why = [&](double mm, float trigger = 1) { return whyNoArc(*process, mm, trigger); };
    CHECK(why(3, 0) == NoArc::released);
    CHECK(why(kNowhere) == NoArc::noMetal);
    CHECK(why(8) == NoArc::tooFar);
    CHECK(why(0.1) == NoArc::touching);
    for (const auto& [mm, end] : {std::pair(1e3 * gtawLongestArc(130) + 0.5, NoArc::tooLong),
                                  {0.1, NoArc::touched},
                                  {kNowhere, NoArc::metalLeft}}) {
        CHECK(why(3) == NoArc::burns);
        CHECK(why(mm) == end);
        CHECK(wentOut(end));
        for (const double later : {3.0, 0.1, 20.0, kNowhere}) // until the trigger's release
            CHECK(why(later) == end);
        CHECK(why(3, 0) == NoArc::released);
    }
    process->reset();
    CHECK(why(3) == NoArc::burns);
}

TEST_CASE("a GMAW torch says why it has no arc, and that a wire is on its way or not fed") {
    ProcessSettings settings;
    GmawSettings& gmaw = settings.choose<Gmaw>();
    gmaw.voltage = 22;
    const auto process = made(settings);
    const auto why = [&](double mm, float trigger = 1) { return whyNoArc(*process, mm, trigger); };
    CHECK(why(15, 0) == NoArc::released);
    CHECK(why(kNowhere) == NoArc::noMetal);
    CHECK(why(40) == NoArc::feeding);
    for (int i = 0; i < 100; ++i)
        why(14);
    CHECK(process->arc().action == ArcAction::burning);
    CHECK(why(60) == NoArc::tooLong);
    CHECK(why(60) == NoArc::tooLong); // until it strikes again
    for (int i = 0; i < 100; ++i)
        why(14);
    CHECK(why(kNowhere) == NoArc::metalLeft);
    CHECK(why(60) == NoArc::metalLeft);
    CHECK(why(60, 0) == NoArc::released);
    CHECK(why(60) == NoArc::feeding);
    gmaw.wireFeedMPerMin = 0;
    process->apply(settings);
    CHECK(why(60) == NoArc::noWire);
    std::set<std::string_view> names;
    for (int i = 0; i <= static_cast<int>(NoArc::usedUp); ++i)
        names.insert(noArcName(NoArc(i)));
    CHECK(names.size() == 12);
}

TEST_CASE("a GTAW electrode that dips in is out and spoiled") {
    ProcessSettings settings;
    settings.choose<Gtaw>();
    const auto process = made(settings);
    after(*process, 2);
    CHECK(after(*process, 0.1) == ArcAction::out);
    CHECK(process->sources().empty());
    CHECK(dynamic_cast<const Gtaw&>(*process).electrodeSpoiled());
    process->reset();
    CHECK_FALSE(dynamic_cast<const Gtaw&>(*process).electrodeSpoiled());
}

TEST_CASE("a GMAW arc and its drops together bring efficiency U I, and every millimetre of wire is found again") {
    ProcessSettings settings;
    GmawSettings& gmaw = settings.choose<Gmaw>();
    gmaw.voltage = GENERATE(18.0F, 22.0F, 28.0F);
    const auto process = made(settings);
    double brought = 0, expected = 0, fedParticles = 0;
    for (int i = 0; i < 1000; ++i) {
        process->step(pulled(), metalAt(15 + 2 * std::sin(0.05 * i)), kStep);
        for (const HeatSource& source : process->sources())
            brought += double(source.power) * kStep;
        for (const MetalSeed& drop : process->drops())
            brought += 7850e-9 * (table().enthalpyAt(double(drop.temperature)) - table().enthalpyAt(293.15));
        const ArcState& arc = process->arc();
        expected += kGmawEfficiency * double(arc.voltage) * double(arc.current) * kStep;
        fedParticles += double(process->drops().size());
    }
    CHECK(process->arc().burns());
    CHECK(brought == Approx(expected).epsilon(0.002));
    const WireAccount wire = process->wire();
    CHECK(wire.fed == Approx(1000 * kStep * 5.8 / 60).epsilon(1e-6));
    CHECK(wire.melted + wire.standing == Approx(wire.fed + 12e-3).epsilon(1e-6));
    CHECK(fedParticles == Approx(wire.melted * wire.area / 1e-9).margin(1));
}

TEST_CASE("an arc too weak for its wire melts less of it, and makes no heat and no cold drops out of nothing") {
    ProcessSettings settings;
    GmawSettings& gmaw = settings.choose<Gmaw>();
    gmaw.voltage = GENERATE(5.0F, 8.0F);
    gmaw.wireFeedMPerMin = 20;
    const auto process = made(settings);
    double brought = 0, electric = 0, coldest = 1e9;
    for (int i = 0; i < 300; ++i) {
        process->step(pulled(), metalAt(12), kStep);
        for (const MetalSeed& drop : process->drops())
            brought += dropHeat(drop);
        for (const MetalSeed& drop : process->drops())
            coldest = std::min(coldest, double(drop.temperature));
        for (const HeatSource& source : process->sources())
            brought += double(source.power) * kStep;
        electric += kGmawEfficiency * double(process->arc().voltage) * double(process->arc().current) * kStep;
    }
    CHECK(brought <= electric + dropHeat({{}, 2500}));
    CHECK(coldest > steel().liquidus - 1);
    const WireAccount wire = process->wire();
    CHECK(wire.fed == Approx(300 * kStep * 20 / 60));
    CHECK(wire.melted < 0.97 * wire.fed);
    CHECK(wire.melted + wire.standing == Approx(wire.fed + 12e-3));
    CHECK(process->arc().action == ArcAction::stubbed);
}

TEST_CASE("a contact tip on the metal lets no wire through and heats nothing") {
    ProcessSettings settings;
    settings.choose<Gmaw>();
    const auto process = made(settings);
    for (int i = 0; i < 100; ++i) {
        CHECK(after(*process, 0.5 - 0.1 * i) == ArcAction::stubbed);
        CHECK(process->sources().empty());
        CHECK(process->drops().empty());
    }
    CHECK(process->wire().fed == 0);
}

TEST_CASE("a flame heats less and less from half its length on") {
    ProcessSettings settings;
    FlameSettings& flame = settings.choose<Flame>();
    flame.power = 1000;
    flame.lengthMm = 40;
    const auto process = made(settings);
    for (const auto& [mm, watts] : {std::pair(0.0, 1000.0), {20.0, 1000.0}, {30.0, 500.0}, {41.0, 0.0}, {45.0, 0.0}}) {
        after(*process, mm);
        CHECK(process->arc().power == Approx(watts).margin(0.1));
        CHECK(process->sources().size() == (watts > 0 ? 1 : 0));
    }
}

TEST_CASE("an arc presses by its current, a flame does not") {
    ProcessSettings settings;
    settings.choose<Gtaw>().current = 200;
    const auto arc = made(settings);
    after(*arc, 3);
    const ArcPressure pressure = arc->pressure();
    const double sigma = double(pressure.sigma);
    CHECK(double(pressure.peak) * 2 * 3.14159265 * sigma * sigma == Approx(4e-3)); // 1e-7 V s/(A m) times 200 A squared
    settings.choose<Flame>();
    const auto flame = made(settings);
    CHECK(after(*flame, 3) == ArcAction::burning);
    CHECK(flame->pressure().peak == 0);
}

TEST_CASE("an arc's heat is the wider the longer and stronger the arc is") {
    CHECK(arcHeatRadius(3e-3, 200) > arcHeatRadius(1e-3, 200));
    CHECK(arcHeatRadius(3e-3, 300) > arcHeatRadius(3e-3, 200));
    CHECK(arcHeatRadius(0, 200) == arcHeatRadius(kShortestSpread, 200)); // dip transfer
    CHECK(arcHeatRadius(5e-3, 190) == Approx(1.84e-3).epsilon(0.02));    // the arc of the fit
}
