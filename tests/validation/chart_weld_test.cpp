// Welds at a chart's values: small, and coarse where that is enough, on each joint.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/validation/validation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>

using namespace meltpool;

namespace {

/// Runs a weld of 6 mm plates of s235, at half of the chart's speed.
ValidationResult weld(const std::string& joint, const std::string& more = "", const char* spacingMm = "2") {
    const auto file = test::scratchFolder("chart-weld") / "case.toml";
    writeTextFileAtomically(file, "name = \"weld\"\nkind = \"chart_" + joint + "\"\nspacing_mm = " + spacingMm +
                                      "\n[material]\nuse = \"s235\"\n[case]\nambient_k = 293\n"
                                      "process = \"gmaw\"\nvoltage = 27\ncurrent_a = 250\nwire_diameter_mm = 1.2\n"
                                      "speed_mm_s = 6\nthickness_mm = 6\nseam_mm = 16\n" +
                                      more);
    return runValidationCase(readValidationCase(file), test::shaders());
}

bool has(const ValidationResult& result, const std::string& name) {
    return std::any_of(result.numbers.begin(), result.numbers.end(),
                       [&](const ValidationNumber& n) { return n.name == name; });
}

double ours(const ValidationResult& result, const std::string& name) {
    INFO(validationText(result));
    const auto found = std::find_if(result.numbers.begin(), result.numbers.end(),
                                    [&](const ValidationNumber& n) { return n.name == name; });
    INFO(name);
    REQUIRE(found != result.numbers.end());
    return found->ours;
}

} // namespace

TEST_CASE("A chart's fillet has its measures for a verdict, and says where its heat went", "[validation]") {
    const ValidationResult result = weld("tee", "leg_mm = 5.5\n");
    INFO(validationText(result));
    REQUIRE(result.weld);
    CHECK(result.weld->measures.kind == WeldKind::fillet);
    CHECK(result.weld->measures.stations.size() >= 5);
    CHECK(*result.weld->nominal.leg == Approx(5.5e-3));
    CHECK(result.weld->nominal.thickness == Approx(6e-3));
    CHECK(ours(result, "leg_lying_mm") == Approx(*result.weld->measures.mean.leg1 * 1e3));
    CHECK(ours(result, "current_a") == Approx(250).epsilon(0.1));
    CHECK(ours(result, "voltage_v") == Approx(27).epsilon(0.01));
    const double drops = ours(result, "heat_by_drops_percent");
    CHECK(drops > 20);
    CHECK(drops < 60);
    CHECK(ours(result, "arc_caught_percent") > 90);
    const double solid = ours(result, "arc_on_solid_percent");
    CHECK(solid > 1);
    CHECK(solid < 99);
    CHECK(ours(result, "arc_on_solid_lying_percent") + ours(result, "arc_on_solid_standing_percent") == Approx(solid));
    CHECK(ours(result, "arc_on_solid_ahead_percent") < solid + 1e-9);
    CHECK(ours(result, "line_warmth_lying_k") > 350);
    CHECK(ours(result, "line_warmth_lying_k") < 2000);
}

TEST_CASE("A chart's voltage and speed change at the feed that the chart's own values need", "[validation]") {
    // Coarser particles change a section by a tenth.
    const ValidationResult slow = weld("tee", "", "1"), fast = weld("tee", "speed_factor = 2\n", "1"),
                           cold = weld("tee", "voltage_offset_v = -4\n", "1");
    CHECK(ours(fast, "current_a") == Approx(ours(slow, "current_a")).epsilon(0.05));
    CHECK(ours(cold, "voltage_v") == Approx(ours(slow, "voltage_v") - 4).epsilon(0.01));
    const auto section = [](const ValidationResult& of) { return *of.weld->measures.mean.deposited; };
    CHECK(section(slow) == Approx(2 * section(fast)).epsilon(0.15));
    CHECK(section(slow) == Approx(section(cold)).epsilon(0.1));
}

TEST_CASE("A lap is asked for no longer leg than its edge has room for", "[validation]") {
    CHECK(*weld("lap", "leg_mm = 8\n").weld->nominal.leg == Approx(6e-3));
}

TEST_CASE("A chart's weld by hand strikes as its process asks and has the filler of rod and electrode",
          "[validation]") {
    const auto byHand = [](const std::string& keys) {
        const auto file = test::scratchFolder("chart-hand") / "case.toml";
        writeTextFileAtomically(file, "name = \"weld\"\nkind = \"chart_tee\"\nspacing_mm = 2\n[material]\n"
                                      "use = \"s235\"\n[case]\nthickness_mm = 6\nseam_mm = 16\n" +
                                          keys);
        return runValidationCase(readValidationCase(file), test::shaders());
    };
    const ValidationResult covered =
        byHand("process = \"smaw\"\ncurrent_a = 130\nelectrode = \"e7018\"\nelectrode_diameter_mm = 3.2\n"
               "speed_mm_s = 2.5\narc_length_mm = 5\ntravel_angle_deg = -15\n");
    CHECK(ours(covered, "current_a") == Approx(130).epsilon(0.05));
    CHECK(ours(covered, "voltage_v") > 20);
    CHECK(*covered.weld->measures.mean.deposited > 10e-6); // 4.9 mm/s of the core burn off: 15 mm2 less what sputters
    const std::string arc = "process = \"gtaw\"\ncurrent_a = 250\nspeed_mm_s = 1.5\narc_length_mm = 4\n";
    const ValidationResult tungsten = byHand(arc + "rod_diameter_mm = 2.4\nrod_feed_mm_s = 3\nrod_ahead_mm = 0\n"),
                           bare = byHand(arc);
    CHECK(ours(tungsten, "current_a") == Approx(250).epsilon(0.05));
    CHECK(ours(tungsten, "voltage_v") < 16);
    CHECK(ours(tungsten, "refused_filler") == 0);
    CHECK(ours(tungsten, "fused_width_mm") > 4);
    // The rod brings 9 mm2 on each millimetre. Without it the pool pushes some metal along: less than a coarse
    // particle's 4 mm2.
    const double filled = *tungsten.weld->measures.mean.deposited;
    CHECK(filled > 5e-6);
    CHECK(std::abs(bare.weld->measures.mean.deposited.value_or(0)) < filled / 2);
}

TEST_CASE("A chart's lap has legs on both plates, and its butt a root in the gap", "[validation]") {
    const ValidationResult lap = weld("lap"), butt = weld("butt", "gap_mm = 2\nweave_mm = 2\n");
    CHECK(lap.weld->measures.kind == WeldKind::fillet);
    CHECK(ours(lap, "leg_standing_mm") > 0);
    CHECK(butt.weld->measures.kind == WeldKind::butt);
    CHECK(has(butt, "root_missing_mm"));
    CHECK_FALSE(has(butt, "leg_lying_mm"));
    CHECK_FALSE(has(butt, "line_warmth_lying_k"));
}
