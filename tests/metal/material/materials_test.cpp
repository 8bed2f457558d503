// Material files: every shipped one is complete, and every fault is named with its line.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/metal/material/heat_table.hpp"
#include "core/metal/material/materials.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cmath>

using namespace meltpool;

namespace {

std::filesystem::path sourceMaterial(const std::string& key) {
    return test::testFolder().parent_path() / "app" / "data" / "materials" / (key + ".toml");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

/// Returns the message for S235 with one replaced text.
std::string faultOf(const std::string& from, const std::string& to) {
    const auto file = test::scratchFolder("material") / "bad.toml";
    writeTextFileAtomically(file, replaced(readTextFile(sourceMaterial("s235")), from, to));
    try {
        readMaterial(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "read without complaint";
}

} // namespace

TEST_CASE("A property is linear between its points and constant beyond", "[materials]") {
    const Property p{{{300, 10}, {400, 20}, {500, 0}}, "test"};
    CHECK(p.at(100) == 10);
    CHECK(p.at(350) == Approx(15));
    CHECK(p.at(450) == Approx(10));
    CHECK(p.at(900) == 0);
    CHECK(p.integral(250, 600) == Approx(500 + 1500 + 1000));
    CHECK(p.integral(400, 300) == Approx(-1500));
}

TEST_CASE("All shipped materials read and make sense", "[materials]") {
    const auto files = materialFiles(sourceMaterial("s235").parent_path());
    CHECK(files.size() >= 9);
    for (const auto& file : files) {
        const Material m = readMaterial(file);
        INFO(m.key);
        CHECK_FALSE(m.solidDensity.source.empty());
        CHECK(m.liquidus >= m.solidus);
        Material clean = m; // sulphur reverses the slope of cold liquid
        clean.sulphur = 0;
        CHECK(clean.tensionSlopeAt(m.liquidus) < 0);
        CHECK(m.tensionSlopeAt(m.liquidus + 300) <= 0);
        const HeatTable table(m);
        double last = -1;
        for (double t = 200; t < 4000; t += 13.7) {
            const double h = table.enthalpyAt(t);
            CHECK(h > last);
            last = h;
            CHECK(table.temperatureAt(h) == Approx(t).epsilon(1e-9));
            CHECK(std::abs(static_cast<double>(table.sampled(static_cast<float>(h))[0]) - t) < 0.3);
            const double theta = table.kirchhoffAt(h);
            CHECK(std::abs(static_cast<double>(table.sampled(static_cast<float>(h))[1]) - theta) < 2e-4 * theta);
        }
    }
}

TEST_CASE("Sulphur lowers surface tension and turns its slope, as the published table", "[materials]") {
    Material iron = readMaterial(sourceMaterial("s235"));
    struct Row {
        double percent, tension, slope, later; // at 1809 K, slope there and at 2200 K, 1e-4 N/(m K)
    };
    for (const Row& row : {Row{0, 1.943, -4.3, -4.3}, Row{0.001, 1.91, -2.5, -4.1}, Row{0.004, 1.83, 0.3, -3.4},
                           Row{0.010, 1.73, 2.4, -2.4}, Row{0.030, 1.56, 3.8, -0.5}}) {
        iron.sulphur = row.percent;
        INFO(row.percent);
        CHECK(iron.tensionAt(1809) == Approx(row.tension).margin(0.006));
        CHECK(1e4 * iron.tensionSlopeAt(1804) == Approx(row.slope).margin(0.15));
        CHECK(1e4 * iron.tensionSlopeAt(2195) == Approx(row.later).margin(0.15));
    }
}

TEST_CASE("Aluminium alone of the shipped metals is welded with alternating current", "[materials]") {
    for (const auto& file : materialFiles(sourceMaterial("s235").parent_path())) {
        const Material m = readMaterial(file);
        INFO(m.key);
        CHECK(m.alternatingCurrent == (m.key == "aluminium-6061"));
        CHECK(m.weldingSource.empty() != m.alternatingCurrent);
    }
}

TEST_CASE("The steel standard's formulas come out of its tables", "[materials]") {
    const Material steel = readMaterial(sourceMaterial("s235"));
    for (const double celsius : {20.0, 137.0, 333.0, 512.0, 580.0}) {
        const double c = 425 + 0.773 * celsius - 1.69e-3 * celsius * celsius + 2.22e-6 * std::pow(celsius, 3);
        CHECK(steel.solidSpecificHeat.at(celsius + 273.15) == Approx(c).epsilon(2e-3));
    }
    CHECK(steel.solidSpecificHeat.at(700 + 273.15) == Approx(666 + 13002.0 / 38).epsilon(0.01));
    CHECK(steel.solidSpecificHeat.at(735 + 273.15) > 4500);
    CHECK(steel.solidSpecificHeat.at(1000 + 273.15) == Approx(650));
    CHECK(steel.solidConductivity.at(400 + 273.15) == Approx(54 - 0.0333 * 400).epsilon(1e-3));
    CHECK(steel.solidConductivity.at(1200 + 273.15) == Approx(27.3));
}

TEST_CASE("The heat table follows its definition", "[materials]") {
    Material m;
    m.solidus = 1700;
    m.liquidus = 1800;
    m.latentHeat = 2.7e5;
    m.solidDensity = m.liquidDensity = Property::constant(7000);
    m.solidConductivity = Property::constant(30);
    m.liquidConductivity = Property::constant(60);
    m.solidSpecificHeat = Property::constant(600);
    m.liquidSpecificHeat = Property::constant(800);
    const HeatTable table(m);
    CHECK(table.solidusEnthalpy() == Approx(600 * 1700));
    CHECK(table.liquidusEnthalpy() == Approx(600 * 1700 + 700 * 100 + 2.7e5));
    CHECK(table.temperatureAt(0.5 * (table.solidusEnthalpy() + table.liquidusEnthalpy())) == Approx(1750));
    CHECK(table.liquidFractionAt(table.enthalpyAt(1775)) == Approx(0.75));
    CHECK(table.kirchhoffAt(table.enthalpyAt(1800)) == Approx(30 * 1700 + 45 * 100));
    CHECK(table.kirchhoffAt(table.enthalpyAt(2000)) == Approx(30 * 1700 + 45 * 100 + 60 * 200));
    CHECK(table.largestDiffusivity(7000, 300, 1000) == Approx(30.0 / 7000 / 600));
    CHECK(HeatTable(m, 2).kirchhoffAt(table.enthalpyAt(2000)) == Approx(30 * 1700 + 75 * 100 + 120 * 200));
}

TEST_CASE("One visible emissivity stands for liquid, clean and scaled metal where they have none of their own",
          "[materials]") {
    const std::string text = readTextFile(sourceMaterial("s235"));
    const auto file = test::scratchFolder("material") / "own.toml";
    writeTextFileAtomically(file, replaced(text, "clean_emissivity = 0.45", "visible_emissivity = 0.5"));
    const MaterialLooks own = readMaterial(file).looks;
    CHECK(own.liquidEmissivity == 0.35f);
    CHECK(own.cleanEmissivity == 0.5f);
    CHECK(own.scaledEmissivity == 0.85f);
    CHECK_THAT(faultOf("clean_emissivity = 0.45\n", ""), test::containsText("clean_emissivity: is missing"));
}

TEST_CASE("A material file's faults are named with their line", "[materials]") {
    using test::containsText;
    CHECK_THAT(faultOf("7850", "-1"), containsText("bad.toml:12: [solid.density] value: expected a number from 1"));
    CHECK_THAT(faultOf("solidus = {", "solidos = {"), containsText("solidus: is missing"));
    CHECK_THAT(faultOf("[liquid]", "[liquid]\ncolour = 3"), containsText("colour: unknown key; known here:"));
    CHECK_THAT(faultOf(", source = \"EN 1993-1-2:2005, 3.2.2\"", ""), containsText("source: is missing"));
    CHECK_THAT(faultOf("[looks]", "[welding]\nalternating_current = 1\nsource = \"none\"\n[looks]"),
               containsText("[welding] alternating_current: expected true or false"));
    CHECK_THAT(faultOf("[looks]", "[welding]\nalternating_current = true\n[looks]"),
               containsText("source: is missing"));
    CHECK_THAT(faultOf("1813.15", "1713.15"), containsText("must not be below the solidus"));
    CHECK_THAT(faultOf("[333.15,", "[233.15,"), containsText("temperatures must rise"));
    CHECK_THAT(faultOf("[boiling]", "[boiling"), containsText("bad.toml:4"));
    CHECK_THAT(faultOf("percent = { value = 0.005", "percent = { value = 0.5"),
               containsText("expected a number from 0 to 0.2"));
    CHECK_THAT(faultOf("[1700, 1.98987]", "[1700, 0.1]"), containsText("leaves no surface tension at the solidus"));
}
