// The first and second law over every shipped lesson and over torches outside lessons: no metal gets colder than the
// coldest, hotter than its source or hotter than boiling, and heat and wire arrive at the torch.
#include "core/training/lesson/lesson.hpp"
#include "core/weld/process/weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

using namespace meltpool;

namespace {

constexpr float kMm = 1e-3F;
/// Tolerance of float arithmetic, K.
constexpr double kRounding = 0.05;
/// Permitted excess (K) of metal under an arc over its boiling point: the vapour carries heat away, and more so from
/// hotter metal.
constexpr double kOverBoiling = 250;

std::filesystem::path dataFolder() {
    return test::testFolder().parent_path() / "app" / "data";
}

/// Lowest and highest temperature of a run, K.
struct Bounds {
    double low = 1e9, high = 0;
    size_t lost = 0, nonFinite = 0;

    void look(Weld& weld) {
        const MetalStatistics seen = weld.metal().statistics();
        low = std::min(low, seen.minTemperature);
        high = std::max(high, seen.maxTemperature);
        lost = std::max(lost, seen.lost);
        nonFinite += seen.nonFinite;
    }
};

template <class Torch>
Bounds boundsOf(Weld& weld, double seconds, const Torch& torchAt) {
    Bounds bounds;
    bounds.look(weld);
    const int steps = static_cast<int>(seconds / weld.timeStep());
    for (int i = 0; i < steps; ++i) {
        weld.step(torchAt(i * weld.timeStep()), nullptr);
        if (i % 6 == 0) bounds.look(weld);
    }
    bounds.look(weld);
    return bounds;
}

/// Shortens the plate to the length needed in the first seconds.
void shorten(Lesson& lesson) {
    if (lesson.workpiece.kind == static_cast<int>(WorkpieceKind::Plate) ||
        lesson.workpiece.kind == static_cast<int>(WorkpieceKind::Tee))
        lesson.workpiece.widthMm = 30;
}

struct Place {
    const char* name;
    glm::vec3 tipMm;
    double pitch; ///< angle from pointing straight down, rad
    bool heats;   ///< true if the metal may take up any heat
};

const Place kPlaces[] = {
    {"over the plate", {0, 3, 0}, 0, true},
    {"buried in the plate", {0, -3, 0}, 0, true},
    {"buried to the middle of a stick-out", {0, -8, 0}, 0, true},
    {"under the plate, pointing away", {0, -14, 0}, 0, false},
    {"over the plate, pointing up", {0, 16, 0}, std::numbers::pi, false},
    {"beside the plate", {0, 3, 25}, 0, false},
    {"a metre away", {0, 3, 1000}, 0, false},
    {"a metre over the plate", {0, 1000, 0}, 0, false},
};

TorchSample torchAt(const Place& place) {
    TorchSample torch;
    torch.tip = place.tipMm * kMm;
    torch.orientation = glm::angleAxis(static_cast<float>(place.pitch - std::numbers::pi / 2), glm::vec3(1, 0, 0));
    torch.trigger = 1;
    return torch;
}

Workpiece smallPlate(const char* metal, float spacingMm = 1) {
    WorkpieceParameters parameters;
    parameters.metal = metal;
    parameters.lengthMm = 24;
    parameters.widthMm = 20;
    parameters.thicknessMm = 6;
    parameters.spacingMm = spacingMm;
    parameters.roomAboveMm = 14;
    return makeWorkpiece(parameters);
}

Material metalNamed(const std::string& metal) {
    return readMaterial(dataFolder() / "materials" / (metal + ".toml"));
}

ProcessSettings processNamed(size_t kind) {
    ProcessSettings settings;
    settings.kind = static_cast<int>(kind);
    return settings;
}

/// Returns the upper bound (K) of all temperatures in this weld.
double hottestAllowed(const ProcessSettings& process, const Material& material) {
    if (process.is<SolderingIron>()) {
        ProcessSettings copy = process;
        return static_cast<double>(copy.of<SolderingIron>().tipTemperatureC) + 273.15;
    }
    return material.boilingPoint + kOverBoiling;
}

/// Welds the lesson's demonstration for a while; no-op for a lesson without a weld.
void checkBounds(const std::string& name) {
    Lesson lesson = findLesson(name, dataFolder() / "lessons");
    if (lesson.model != LessonModel::Weld) return;
    shorten(lesson);
    const Material material = metalNamed(lesson.workpiece.metal);
    Weld weld(test::shaders(), material, makeWorkpiece(lesson.workpiece), lesson.process);
    const double start = 1.0; // the torch approaches in the first second
    const Bounds bounds =
        boundsOf(weld, 2.5, [&](double time) { return lesson.torch.sample(time < 1e-3 ? 0 : time + start * 0.2); });
    INFO(name << ": " << bounds.low << " to " << bounds.high << " K");
    CHECK(bounds.low > std::min(293.15, static_cast<double>(lesson.workpiece.temperatureC) + 273.15) - kRounding);
    CHECK(bounds.high > 400); // the metal was heated
    CHECK(bounds.high < material.boilingPoint + kOverBoiling);
    CHECK(bounds.nonFinite == 0);
}

} // namespace

TEST_CASE("shipped lessons stay between their coldest start and their boiling point, others of them every day",
          "[training][bounds]") {
    constexpr size_t kDays = 4;
    const std::vector<std::string> names = lessonNames(dataFolder() / "lessons");
    REQUIRE(names.size() > kDays);
    for (size_t i = static_cast<size_t>(std::time(nullptr) / 86400) % kDays; i < names.size(); i += kDays)
        checkBounds(names[i]);
}

TEST_CASE("every shipped lesson stays between its coldest start and its boiling point", "[training][bounds][long]") {
    for (const std::string& name : lessonNames(dataFolder() / "lessons"))
        checkBounds(name);
}

TEST_CASE("wherever a torch is, its heat obeys the first and second law", "[training][bounds]") {
    const Workpiece plate = smallPlate("s235");
    const Material material = metalNamed("s235");
    for (size_t kind = 0; kind < AllProcesses::kCount; ++kind) {
        const ProcessSettings process = processNamed(kind);
        Weld weld(test::shaders(), material, plate, process);
        for (const Place& place : kPlaces) {
            weld.reset();
            const double before = weld.metal().state().readEnergy();
            const Bounds bounds = boundsOf(weld, 0.6, [&](double) { return torchAt(place); });
            INFO(AllProcesses::kNames[kind] << " " << place.name << ": " << bounds.low << " to " << bounds.high
                                            << " K");
            CHECK(bounds.low > 293.15 - kRounding);
            CHECK(bounds.high < hottestAllowed(process, material));
            CHECK(bounds.nonFinite == 0);
            if (place.heats) continue;
            CHECK(bounds.high < 293.15 + kRounding);
            CHECK(weld.metal().state().readEnergy() == Approx(before).epsilon(1e-6));
            CHECK(weld.metal().state().particles() == plate.seeds.size()); // no wire has arrived
        }
    }
}

TEST_CASE("metal takes up no more than the arc's power, and drops its part of it", "[training][bounds]") {
    const Material material = metalNamed("s235");
    for (const float voltage : {5.0F, 12.0F, 20.0F}) {
        ProcessSettings process;
        process.choose<Gmaw>().voltage = voltage;
        Weld weld(test::shaders(), material, smallPlate("s235"), process, {.lossless = true});
        const double particle = weld.metal().state().particleMass();
        const double cold = weld.metal().table().enthalpyAt(293.15);
        const double before = weld.metal().state().readEnergy();
        double given = 0;
        const int steps = static_cast<int>(1.5 / weld.timeStep());
        for (int i = 0; i < steps; ++i) {
            weld.step(torchAt(kPlaces[0]), nullptr);
            given += weld.arc().power * weld.timeStep();
        }
        const double fed = static_cast<double>(weld.process().filler().fed()) * particle * cold;
        const double gained = weld.metal().state().readEnergy() - before - fed;
        INFO(voltage << " V: " << gained << " J of " << given << " J");
        CHECK(gained <= given * 1.001 + 1);
        if (voltage > 15) CHECK(gained > 0.95 * given);
    }
}

TEST_CASE("metal of every kind boils under a flame that stands still, and gets no hotter", "[training][bounds]") {
    for (const char* metal : {"gallium", "sn60pb40", "paraffin", "ice", "aluminium-6061"}) {
        const Material material = metalNamed(metal);
        REQUIRE(material.boilingPoint > 0);
        ProcessSettings process;
        FlameSettings& flame = process.choose<Flame>();
        flame.power = 4000;
        WorkpieceParameters parameters;
        parameters.lengthMm = parameters.widthMm = 16;
        parameters.thicknessMm = 6;
        parameters.spacingMm = 2;
        parameters.temperatureC = metal == std::string("ice") ? -10 : 20;
        Weld weld(test::shaders(), material, makeWorkpiece(parameters), process);
        const Bounds bounds = boundsOf(weld, 1.5, [&](double) { return torchAt(kPlaces[0]); });
        INFO(metal << ": " << bounds.low << " to " << bounds.high << " K");
        CHECK(bounds.low > static_cast<double>(parameters.temperatureC) + 273.15 - kRounding);
        CHECK(bounds.high > 0.5 * material.boilingPoint);
        CHECK(bounds.high < material.boilingPoint + kOverBoiling);
    }
}

TEST_CASE("a torch that stands still for a minute keeps to its bounds", "[training][bounds][long]") {
    for (size_t kind = 0; kind < AllProcesses::kCount; ++kind) {
        const ProcessSettings process = processNamed(kind);
        const Material material = metalNamed("s235");
        Weld weld(test::shaders(), material, smallPlate("s235", 2), process);
        const Bounds bounds = boundsOf(weld, 60, [&](double) { return torchAt(kPlaces[0]); });
        INFO(AllProcesses::kNames[kind] << ": " << bounds.low << " to " << bounds.high << " K");
        CHECK(bounds.low > 293.15 - kRounding);
        CHECK(bounds.high < hottestAllowed(process, material));
        CHECK(bounds.nonFinite == 0);
    }
}
