// Beads, fillets, arc spots and cooling rates: small welds whose figures agree with geometry and balance.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/validation/validation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>

using namespace meltpool;

namespace {

/// Runs a weld of s235 with particles of 2 mm: quick, and coarse.
ValidationResult weld(const std::string& kind, const std::string& keys) {
    const auto file = test::scratchFolder("weld-case") / "case.toml";
    writeTextFileAtomically(file, "name = \"weld\"\nkind = \"" + kind +
                                      "\"\nspacing_mm = 2\n[material]\nuse = \"s235\"\n" + "[case]\nambient_k = 293\n" +
                                      keys);
    return runValidationCase(readValidationCase(file), test::shaders());
}

const ValidationNumber& number(const ValidationResult& result, const std::string& name) {
    INFO(validationText(result));
    const auto found = std::find_if(result.numbers.begin(), result.numbers.end(),
                                    [&](const ValidationNumber& n) { return n.name == name; });
    INFO(name);
    REQUIRE(found != result.numbers.end());
    return *found;
}

double ours(const ValidationResult& result, const std::string& name) {
    return number(result, name).ours;
}

constexpr const char* kGmaw = "process = \"gmaw\"\nvoltage = 24\nwire_feed_m_min = 8\nwire_diameter_mm = 1.2\n"
                              "ctwd_mm = 15\n";

} // namespace

TEST_CASE("A bead tells current, toes, height, angle and deposit of the wire that was fed", "[validation]") {
    const ValidationResult result =
        weld("bead_on_plate", std::string(kGmaw) + "speed_mm_s = 8\nplate_mm = [60, 8, 40]\n");
    const double fed = 3.14159265 / 4 * 1.2 * 1.2 * 8000 / 60 / 8; // cross-section of the bead, mm²
    CHECK(number(result, "deposited_mm2").passed);
    CHECK(ours(result, "deposited_mm2") == Approx(fed).epsilon(0.15)); // the arc starts and ends inside the path
    CHECK(ours(result, "current_a") > 150);
    CHECK(ours(result, "current_a") < 350);
    CHECK(ours(result, "toe_width_mm") > ours(result, "height_mm"));
    // A circular segment with this width and height has the area of the deposit.
    const double width = ours(result, "toe_width_mm"), height = ours(result, "height_mm");
    CHECK(ours(result, "section_mm2") > 0.5 * width * height);
    CHECK(ours(result, "section_mm2") < 1.1 * width * height);
    CHECK(ours(result, "edge_angle_deg") == Approx(2 * std::atan2(height, 0.5 * width) * 180 / 3.14159265).margin(12));
    CHECK(ours(result, "overlap_mm") >= width - ours(result, "fused_width_mm") - 2);
}

TEST_CASE("A fillet has legs on both plates, and more wire makes them longer", "[validation]") {
    const auto fillet = [](double speed) {
        return weld("fillet", std::string(kGmaw) + "plate_mm = [50, 6, 36]\nstanding_mm = 24\nspeed_mm_s = " +
                                  formatNumber(speed) + "\n");
    };
    const ValidationResult slow = fillet(4), fast = fillet(9);
    for (const ValidationResult* one : {&slow, &fast}) {
        INFO(validationText(*one));
        CHECK(number(*one, "deposited_mm2").passed);
        const double base = ours(*one, "leg_lying_mm"), upright = ours(*one, "leg_standing_mm");
        CHECK(ours(*one, "leg_mm") == Approx(0.5 * (base + upright)));
        CHECK(ours(*one, "throat_mm") < std::max(base, upright));
        CHECK(ours(*one, "throat_mm") > 0.4 * std::min(base, upright));
        CHECK(ours(*one, "root_fusion_mm") >= 0);
    }
    CHECK(ours(slow, "leg_mm") > ours(fast, "leg_mm") + 0.5);
    CHECK(ours(slow, "leg_mm") == Approx(std::sqrt(2 * ours(slow, "deposited_mm2"))).epsilon(0.35)); // mitre fillet
}

TEST_CASE("A fillet that is given a current draws it, by the wire that melts above the filled corner", "[validation]") {
    for (const double current : {180.0, 280.0}) {
        const ValidationResult result =
            weld("fillet", "process = \"gmaw\"\nwire_diameter_mm = 1.2\nctwd_mm = 15\nvoltage = " +
                               formatNumber(current / 10) + "\ncurrent_a = " + formatNumber(current) +
                               "\nplate_mm = [50, 6, 36]\nstanding_mm = 24\nspeed_mm_s = 6\n");
        INFO(validationText(result));
        CHECK(ours(result, "current_a") == Approx(current).epsilon(0.05));
        CHECK(number(result, "deposited_mm2").passed);
    }
}

TEST_CASE("An arc spot grows while the arc burns, with wire and without", "[validation]") {
    const auto spot = [](const std::string& process, double seconds) {
        return weld("arc_spot", process + "plate_mm = [36, 8, 36]\non_s = " + formatNumber(seconds) + "\n");
    };
    const ValidationResult early = spot(kGmaw, 0.4), late = spot(kGmaw, 1.2);
    CHECK(ours(late, "diameter_mm") > ours(early, "diameter_mm"));
    CHECK(ours(late, "height_mm") > 0);
    const std::string tungsten = "process = \"gtaw\"\ncurrent_a = 200\narc_length_mm = 3\n";
    const ValidationResult brief = spot(tungsten, 1), lasting = spot(tungsten, 4);
    CHECK(ours(lasting, "current_a") == Approx(200).epsilon(0.02));
    CHECK(ours(lasting, "fused_diameter_mm") > ours(brief, "fused_diameter_mm"));
    CHECK(ours(lasting, "penetration_mm") > ours(brief, "penetration_mm"));
    CHECK(std::none_of(lasting.numbers.begin(), lasting.numbers.end(),
                       [](const ValidationNumber& n) { return n.name == "diameter_mm"; }));
}

TEST_CASE("A weld of more heat cools more slowly", "[validation]") {
    const auto cooling = [](double speed, const std::string& more) {
        return weld("cooling",
                    std::string(kGmaw) + "plate_mm = [50, 12, 44]\nspeed_mm_s = " + formatNumber(speed) + "\n" + more);
    };
    const ValidationResult slow = cooling(5, ""), fast = cooling(15, "until_k = 770\n");
    INFO(validationText(slow) + validationText(fast));
    CHECK(ours(fast, "cooling_rate_k_s") > 1.2 * ours(slow, "cooling_rate_k_s"));
    CHECK(ours(slow, "hottest_k") > 1730);
    // Thick plate, EN 1011-2: (6700 - 5 T0) Q [1 / (500 - T0) - 1 / (800 - T0)] with Q in kJ/mm and the efficiency of
    // the arc.
    const double heat = 0.85 * ours(fast, "voltage_v") * ours(fast, "current_a") / 15e3;
    const double t85 = (6700 - 5 * 20) * heat * (1.0 / 480 - 1.0 / 780);
    CHECK(ours(fast, "t85_s") == Approx(t85).epsilon(0.4));
    for (const ValidationNumber& n : slow.numbers)
        CHECK(n.name != "t85_s"); // the run ends before that
    CHECK_THROWS_AS(cooling(15, "hot_k = 9000\n"), InputError);
}
