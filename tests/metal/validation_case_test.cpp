// Case files: the documented format reads, everything else is refused with its line.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/metal/validation_case.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

constexpr const char* kStepCase = R"(name = "step"
kind = "conduction_step"
spacing_mm = 0.5
time_s = 2.0
tolerance_percent = 3
[material]
density = 7000
conductivity = 30
specific_heat_solid = 700
specific_heat_liquid = 800
[case]
wall_temperature_k = 1500
initial_temperature_k = 293
at_mm = [1, 2.5]
)";

ValidationCase readText(const std::string& text) {
    const auto file = test::scratchFolder("case") / "case.toml";
    writeTextFileAtomically(file, text);
    return readValidationCase(file);
}

std::string faultOf(const std::string& from, const std::string& to) {
    std::string text = kStepCase;
    text.replace(text.find(from), from.size(), to);
    try {
        readText(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "read without complaint";
}

} // namespace

TEST_CASE("A case reads as written", "[validation]") {
    const ValidationCase c = readText(kStepCase);
    CHECK(c.name == "step");
    CHECK(c.kind->name == "conduction_step");
    CHECK(c.spacing == Approx(0.5e-3));
    CHECK(c.time == 2);
    CHECK(c.tolerancePercent == 3);
    CHECK(c.number("wall_temperature_k") == 1500);
    CHECK(c.list("at_mm") == std::vector{1.0, 2.5});
    CHECK(c.material.liquidSpecificHeat.at(300) == 800);
    CHECK(c.material.solidSpecificHeat.at(300) == 700);
    CHECK(c.material.liquidConductivity.at(300) == 30);
}

TEST_CASE("A case may use a shipped material, override it and bring measured values", "[validation]") {
    const ValidationCase c = readText(R"(name = "cavity"
kind = "cavity_melting"
spacing_mm = 1
[material]
use = "gallium"
conductivity = 31
[case]
width_mm = 88.9
height_mm = 63.5
hot_k = 311.15
cold_k = 301.15
initial_k = 301.15
times_s = [132, 198]
[measured]
melted_fraction = [0.12, 0.161]
melted_fraction_tolerance_percent = 12
)");
    CHECK(c.material.latentHeat == Approx(80160));
    CHECK(c.material.solidConductivity.at(300) == 31);
    CHECK(c.measured.at("melted_fraction").values == std::vector{0.12, 0.161});
    CHECK(c.measured.at("melted_fraction").tolerancePercent == 12);
}

TEST_CASE("A case's faults are named with their line", "[validation]") {
    using test::containsText;
    CHECK_THAT(faultOf("conduction_step", "conduction"), containsText("case.toml:2: kind: unknown kind 'conduction'"));
    CHECK_THAT(faultOf("spacing_mm = 0.5", "spacing_mm = -1"),
               containsText("case.toml:3: spacing_mm: expected a number"));
    CHECK_THAT(faultOf("time_s = 2.0\n", ""), containsText("time_s: is missing"));
    CHECK_THAT(faultOf("density = 7000", "densety = 7000"), containsText("density: is missing"));
    CHECK_THAT(faultOf("density = 7000", "density = 7000\ncolour = 1"),
               containsText("case.toml:8: [material] colour: unknown key"));
    CHECK_THAT(faultOf("at_mm = [1, 2.5]", "at_mm = []"), containsText("case.toml:14: [case] at_mm: expected a list"));
    CHECK_THAT(faultOf("at_mm = [1, 2.5]", "at_mm = [1, \"x\"]"),
               containsText("case.toml:14: [case] at_mm: expected a number"));
    CHECK_THAT(faultOf("[case]", "[case]\npower_w = 1"), containsText("case.toml:12: [case] power_w: unknown key"));
    CHECK_THAT(faultOf("[material]", "[measured]\nwidth_mm = 1\n[material]"),
               containsText("this kind has no such result"));
    CHECK_THAT(faultOf("density = 7000", "use = \"unobtainium\""),
               containsText("unknown material 'unobtainium'; expected one of 304"));
    CHECK_THAT(faultOf("= 1500", "= nan"), containsText("case.toml:12"));
    CHECK_THAT(faultOf("wall_temperature_k = 1500", "wall_temperature_k = "), containsText("case.toml:12"));
}
