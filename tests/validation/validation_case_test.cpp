// Case files: the documented format is read, all else is refused with its line.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/validation/validation_case.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>

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
               containsText("this case has no such result"));
    CHECK_THAT(faultOf("density = 7000", "use = \"unobtainium\""),
               containsText("unknown material 'unobtainium'; expected one of 304"));
    CHECK_THAT(faultOf("= 1500", "= nan"), containsText("case.toml:12"));
    CHECK_THAT(faultOf("wall_temperature_k = 1500", "wall_temperature_k = "), containsText("case.toml:12"));
}

namespace {

std::string faultOfCase(const std::string& kind, const std::string& keys, const std::string& material) {
    try {
        readText("name = \"one\"\nkind = \"" + kind + "\"\nspacing_mm = 1\ntime_s = 1\n[material]\ndensity = 7000\n" +
                 "conductivity = 30\nspecific_heat = 700\n" + material + "\n[case]\n" + keys + "\n");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("A case that makes no sense as a whole says what was expected", "[validation]") {
    using test::containsText;
    const std::string melting = "latent_heat = 2.7e5\nsolidus_k = 1750";
    const auto front = [&](const std::string& phases, double wall, double initial, const std::string& material) {
        return faultOfCase("stefan_" + phases + "_phase",
                           "wall_temperature_k = " + std::to_string(wall) +
                               "\ninitial_temperature_k = " + std::to_string(initial),
                           material);
    };
    CHECK(front("one", 2200, 1750.4, melting).empty());
    CHECK(front("one", 1200, 1750, melting).empty());
    CHECK(front("two", 1200, 1800, melting).empty());
    CHECK_THAT(front("one", 2200, 1750, "solidus_k = 1750"), containsText("latent_heat"));
    CHECK_THAT(front("one", 2200, 1750, "latent_heat = 1e5"), containsText("solidus_k"));
    CHECK_THAT(front("one", 2200, 300, melting), containsText("stefan_two_phase"));
    CHECK_THAT(front("one", 1750, 1750, melting), containsText("wall_temperature_k"));
    CHECK_THAT(front("two", 2200, 1800, melting), containsText("at or below the solidus"));
    CHECK_THAT(front("two", 1200, 1700, melting), containsText("at or above the liquidus"));
    const auto point = [&](const std::string& at) {
        return faultOfCase(
            "rosenthal_thin",
            "power_w = 1500\nspeed_mm_s = 5\ninitial_temperature_k = 293\nthickness_mm = 6\nat_mm = [" + at + "]", "");
    };
    CHECK(point("[-10, 0, 6]").empty());
    CHECK_THAT(point("[-10, 0, 6.5]"), containsText("thickness"));
    CHECK_THAT(point("[-10, 0, -1]"), containsText("surface"));
    CHECK_THAT(point("[0, 0, 3]"), containsText("away from the source"));
}

TEST_CASE("Measured values name what the case yields", "[validation]") {
    using test::containsText;
    const auto step = [](const std::string& measured) {
        return faultOfCase(
            "conduction_step",
            "wall_temperature_k = 1500\ninitial_temperature_k = 293\nat_mm = [1, 2.5]\n[measured]\n" + measured, "");
    };
    CHECK(step("'temperature_at_2.5mm_k' = 800\n'temperature_at_2.5mm_k_tolerance_percent' = 5").empty());
    CHECK_THAT(step("temperature_at_3mm_k = 800"), containsText("one of temperature_at_1mm_k, temperature_at_2.5mm_k"));
    CHECK_THAT(step("mm = 800"), containsText("no such result"));
    CHECK_THAT(step("temperature_at_1mm_k = [800, 900]"), containsText("expected 1 value"));
    CHECK_THAT(step("temperature_at_3mm_k_tolerance_percent = 5"), containsText("unknown key"));
    const std::string bead = "power_w = 4000\nefficiency = 0.8\narc_sigma_mm = 1.6\nspeed_mm_s = 10\n"
                             "wire_feed_m_min = 7\nplate_mm = [60, 9, 30]\nambient_k = 293\n";
    CHECK(faultOfCase("bead_on_plate", bead + "wire_diameter_mm = 1\n[measured]\nheight_mm = 2", "").empty());
    CHECK_THAT(faultOfCase("bead_on_plate", bead + "wire_diameter_mm = 0\n[measured]\nheight_mm = 2", ""),
               containsText("no such result"));
    CHECK_THAT(faultOfCase("cavity_melting",
                           "width_mm = 20\nheight_mm = 20\nhot_k = 2000\ncold_k = 1600\ninitial_k = 1600\n"
                           "times_s = [1, 2]\n[measured]\nmelted_fraction = 0.1",
                           "latent_heat = 2.7e5\nsolidus_k = 1750"),
               containsText("expected 2 values, one for each of times_s"));
}

namespace {

Material materialOf(const std::string& kind, const std::string& keys, const std::string& material) {
    return readText("name = \"one\"\nkind = \"" + kind + "\"\nspacing_mm = 1\ntime_s = 1\n[material]\n" + material +
                    "\n[case]\n" + keys + "\n")
        .material;
}

} // namespace

TEST_CASE("A case's material needs what its kind looks at, in any of its forms", "[validation]") {
    const auto drop = [](const std::string& material) {
        return materialOf("droplet_pressure", "radius_mm = 6", material);
    };
    CHECK(drop("density = 7000\nsurface_tension = 1.8").liquidDensity.at(300) == 7000);
    CHECK(drop("density_liquid = 6900\nsurface_tension = 1.8").solidDensity.at(300) == 6900);
    CHECK(drop("use = \"S235\"").tensionAt(1813) == Approx(1.8).epsilon(0.05));
    CHECK(drop("use = \"S235\"\nsulphur_percent = 0.03").sulphur == 0.03);
    CHECK(drop("use = \"S235\"\nsurface_tension = 1.8").tensionAt(1813) == 1.8); // the given value, unreduced
    CHECK_THROWS_AS(drop("use = \"S235\"\nsulphur_percent = 0.3"), InputError);
    CHECK_THROWS_AS(drop("use = \"S235\"\nsurface_tension = 0.1\nsulphur_percent = 0.1"), InputError);
    CHECK(drop("use = \"aluminium_6061\"").key == "aluminium-6061");
    CHECK_THROWS_AS(drop("density = 7000"), InputError);                      // no surface tension
    CHECK_THROWS_AS(drop("density = 7000\nsurface_tension = 0"), InputError); // zero tension has no effect
    CHECK_THROWS_AS(materialOf("poiseuille", "gap_mm = 6\nbody_force_n_m3 = 1", "density = 1000"), InputError);
    CHECK(
        materialOf("poiseuille", "gap_mm = 6\nbody_force_n_m3 = 1", "density = 1000\nviscosity = 1").viscosity.at(0) ==
        1);
    CHECK(materialOf("hydrostatic", "height_mm = 20", "density = 1000").solidus == kNeverMelts);
    const auto weld = [](const std::string& material) {
        return materialOf("energy", "power_w = 1500\non_s = 2", material);
    };
    CHECK_THROWS_AS(weld("density = 7000\nspecific_heat = 700"), InputError); // no conductivity
    const Material m = weld("density_solid = 7800\nconductivity_solid = 30\nconductivity = 35\nspecific_heat = 700\n"
                            "specific_heat_liquid = 800\nliquidus_k = 1750");
    CHECK(m.liquidDensity.at(300) == 7800);
    CHECK(m.solidConductivity.at(300) == 30);
    CHECK(m.liquidConductivity.at(300) == 35);
    CHECK(m.solidSpecificHeat.at(300) == 700);
    CHECK(m.liquidSpecificHeat.at(300) == 800);
    CHECK(m.solidus == 1750);
    CHECK(m.surfaceTension.at(1750) > 0);
    CHECK(m.viscosity.at(1750) > 0);
}

namespace {

struct KindAndKeys {
    std::string kind, keys;
};

/// Every kind with its documented keys.
const std::vector<KindAndKeys> kKinds{
    {"conduction_step", "wall_temperature_k = 1500\ninitial_temperature_k = 293\nat_mm = [1, 2, 5]"},
    {"conduction_flux", "flux_w_m2 = 5e6\ninitial_temperature_k = 293\nat_mm = [0, 1]"},
    {"stefan_one_phase", "wall_temperature_k = 2200\ninitial_temperature_k = 1750"},
    {"stefan_two_phase", "wall_temperature_k = 2200\ninitial_temperature_k = 293"},
    {"rosenthal_thick",
     "power_w = 1500\nspeed_mm_s = 5\ninitial_temperature_k = 293\nthickness_mm = 6\nat_mm = [[-10, 0, 0], [0, 5, 0]]"},
    {"rosenthal_thin",
     "power_w = 1500\nspeed_mm_s = 5\ninitial_temperature_k = 293\nthickness_mm = 6\nat_mm = [[-10, 0, 0]]"},
    {"energy", "power_w = 1500\non_s = 2\nloss = true"},
    {"energy", "power_w = 1500\non_s = 2\nloss = 40.5"},
    {"energy", "power_w = 2500\non_s = 2\nspeed_mm_s = 6\nwire_diameter_mm = 1\nwire_feed_m_min = 4"},
    {"hydrostatic", "height_mm = 20"},
    {"dam_break", "width_mm = 57.15"},
    {"droplet_pressure", "radius_mm = 6"},
    {"droplet_oscillation", "radius_mm = 4"},
    {"sessile_drop", "volume_mm3 = 500\ncontact_angle_deg = 101"},
    {"poiseuille", "gap_mm = 10\nbody_force_n_m3 = 100"},
    {"cavity_melting", "width_mm = 88.9\nheight_mm = 63.5\nhot_k = 2000\ncold_k = 1600\ninitial_k = 1600\n"
                       "times_s = [132, 198]"},
    {"bead_on_plate", "power_w = 4000\nefficiency = 0.8\narc_sigma_mm = 1.6\nspeed_mm_s = 10\nwire_diameter_mm = 1.0\n"
                      "wire_feed_m_min = 7\nplate_mm = [60, 9, 30]\nambient_k = 293"},
    {"bead_on_plate", "process = \"gmaw\"\nvoltage = 20\nspeed_mm_s = 10\nwire_diameter_mm = 1.0\nctwd_mm = 14\n"
                      "wire_feed_m_min = 7\nplate_mm = [60, 9, 30]\nambient_k = 293"},
    {"fillet", "process = \"gmaw\"\nvoltage = 20\ncurrent_a = 130\nspeed_mm_s = 9\nwire_diameter_mm = 1.0\n"
               "plate_mm = [60, 4, 30]\nambient_k = 293\nwork_angle_deg = 40\ntravel_angle_deg = 10\nstanding_mm = 20"},
    {"chart_tee", "process = \"gmaw\"\nvoltage = 20\ncurrent_a = 150\nspeed_mm_s = 8.3\nwire_diameter_mm = 1.2\n"
                  "thickness_mm = 3.2\nleg_mm = 3.5\nseam_mm = 20\nvoltage_offset_v = -4\nspeed_factor = 2\n"
                  "ambient_k = 293"},
    {"chart_lap", "process = \"gmaw\"\nvoltage = 20\ncurrent_a = 150\nspeed_mm_s = 8.3\nwire_diameter_mm = 1.2\n"
                  "thickness_mm = 3.2\naim_mm = 0.4\ntravel_angle_deg = 10\nambient_k = 293"},
    {"chart_butt", "process = \"gmaw\"\nvoltage = 20\ncurrent_a = 150\nspeed_mm_s = 8.3\nwire_diameter_mm = 1.2\n"
                   "thickness_mm = 3.2\ngap_mm = 1.1\nweave_mm = 2\nweave_hz = 5\nambient_k = 293"},
    {"arc_spot", "process = \"gtaw\"\ncurrent_a = 130\non_s = 2\nplate_mm = [30, 6, 30]\nambient_k = 293"},
    {"cooling", "power_w = 1500\nvoltage = 18\nspeed_mm_s = 9\nwire_diameter_mm = 1.0\nwire_feed_m_min = 5\n"
                "plate_mm = [60, 4, 30]\nambient_k = 293\nhot_k = 1700\ncold_k = 1500\nuntil_k = 773"},
};

std::string caseOf(const std::string& kind, const std::string& keys) {
    return "name = \"one\"\nkind = \"" + kind + "\"\nspacing_mm = 0.5\ntime_s = 2.0\ntolerance_percent = 3\n" +
           "[material]\ndensity_solid = 7800\ndensity_liquid = 7000\nconductivity = 30\nspecific_heat = 700\n"
           "latent_heat = 2.7e5\nsolidus_k = 1750\nliquidus_k = 1800\nsurface_tension = 1.8\nviscosity = 0.006\n"
           "emissivity = 0.7\n[case]\n" +
           keys + "\n";
}

} // namespace

TEST_CASE("Every documented kind takes its documented keys and needs each of them", "[validation]") {
    std::vector<std::string> seen;
    for (const KindAndKeys& one : kKinds) {
        INFO(one.kind);
        const ValidationCase read = readText(caseOf(one.kind, one.keys));
        CHECK(read.kind->name == one.kind);
        seen.push_back(one.kind);
        for (const CaseKey& key : read.kind->keys) {
            if (key.fallback) continue;
            INFO(key.key);
            std::string fewer = one.keys;
            fewer.insert(fewer.find(key.key), "x"); // an unknown key replaces the required one
            CHECK_THROWS_AS(readText(caseOf(one.kind, fewer)), InputError);
        }
    }
    for (const CaseKind& kind : caseKinds())
        CHECK(std::count(seen.begin(), seen.end(), kind.name) > 0);
}

namespace {

constexpr const char* kWeld = "speed_mm_s = 9\nplate_mm = [60, 4, 30]\nambient_k = 293\n";

/// Returns the fault of a weld with these process keys; empty without a fault.
std::string weldFault(const std::string& kind, const std::string& keys) {
    try {
        readText(caseOf(kind, std::string(kind == "arc_spot" ? std::string(kWeld).substr(15) : kWeld) + keys));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("The keys of a weld's process fit the process, or a sentence says which one is wrong", "[validation]") {
    using test::containsText;
    const std::string machine = "process = \"gmaw\"\nvoltage = 20\nwire_diameter_mm = 1\nwire_feed_m_min = 7\n";
    for (const std::string kind : {"bead_on_plate", "fillet", "cooling"})
        CHECK(weldFault(kind, machine) == "");
    CHECK(weldFault("arc_spot", machine + "on_s = 1\n") == "");
    CHECK(weldFault("bead_on_plate", "process = \"gtaw\"\ncurrent_a = 130\n") == "");
    const auto bead = [](const std::string& keys) { return weldFault("bead_on_plate", keys); };
    CHECK_THAT(bead("process = \"mma\"\n"),
               containsText("case.toml:21: [case] process: unknown process 'mma'; expected gmaw or gtaw"));
    CHECK_THAT(bead("process = 3\n"), containsText("process"));
    CHECK_THAT(bead("process = \"gmaw\"\nvoltage = 20\nwire_feed_m_min = 7\n"),
               containsText("wire_diameter_mm: is missing; expected the diameter of the wire"));
    CHECK_THAT(bead("process = \"gmaw\"\nvoltage = 20\nwire_diameter_mm = 1\n"),
               containsText("wire_feed_m_min: is missing; expected"));
    CHECK_THAT(bead("process = \"gmaw\"\nwire_feed_m_min = 7\nwire_diameter_mm = 1\n"),
               containsText("voltage: is missing; expected"));
    CHECK_THAT(bead("process = \"gtaw\"\ncurrent_a = 130\nwire_feed_m_min = 7\n"),
               containsText("wire_feed_m_min: a gtaw arc has no wire"));
    CHECK_THAT(bead("process = \"gtaw\"\n"), containsText("power_w: is missing"));
    CHECK_THAT(bead(machine + "ctwd_mm = 0\n"), containsText("[case] ctwd_mm: expected a number"));
    CHECK_THAT(weldFault("fillet", "process = \"gtaw\"\ncurrent_a = 130\n"), containsText("a fillet needs filler"));
    CHECK_THAT(weldFault("fillet", machine + "work_angle_deg = 90\n"), containsText("work_angle_deg: expected"));
    CHECK_THAT(weldFault("cooling", machine + "hot_k = 1000\n"), containsText("cold_k: expected less than hot_k"));
    CHECK_THAT(weldFault("cooling", machine + "until_k = 1600\n"), containsText("until_k: expected at most cold_k"));
    CHECK_THAT(weldFault("cooling", machine + "until_k = 290\n"), containsText("ambient_k: expected less"));
}

TEST_CASE("A bead's fused width may be measured under its former name", "[validation]") {
    const std::string bead = std::string(kWeld) + "process = \"gtaw\"\ncurrent_a = 130\n[measured]\n";
    const ValidationCase c = readText(caseOf("bead_on_plate", bead + "width_mm = 6\nwidth_mm_tolerance_percent = 7"));
    CHECK(c.measured.at("fused_width_mm").values == std::vector{6.0});
    CHECK(c.measured.at("fused_width_mm").tolerancePercent == 7);
    CHECK_FALSE(c.measured.contains("width_mm"));
    CHECK_THROWS_AS(readText(caseOf("bead_on_plate", bead + "width_mm = 6\nfused_width_mm = 6")), InputError);
    CHECK_THROWS_AS(readText(caseOf("bead_on_plate", bead + "toe_width_mm = 6")), InputError); // a bead requires wire
}

TEST_CASE("The cases beside the shipped ones read, each with what was measured", "[validation]") {
    struct Folder {
        const char* name;
        size_t cases;
        std::vector<const char*> measured;
    };
    for (const Folder& folder :
         {Folder{"logged", 15, {"current_a", "toe_width_mm", "height_mm", "edge_angle_deg"}},
          Folder{"vendor", 8, {"current_a", "leg_mm"}}, Folder{"pyrometer", 9, {"cooling_rate_k_s"}},
          Folder{"replicated", 12, {"height_mm"}}, Folder{"clad", 8, {"penetration_mm", "toe_width_mm", "height_mm"}},
          Folder{"spots", 6, {"diameter_mm"}}}) {
        const auto files = validationCaseFiles(test::testFolder() / "validation" / folder.name);
        CHECK(files.size() == folder.cases);
        for (const auto& file : files) {
            INFO(file.string());
            const ValidationCase c = readValidationCase(file);
            CHECK(c.process == "gmaw");
            for (const char* name : folder.measured)
                CHECK(c.measured.contains(name));
        }
    }
}
