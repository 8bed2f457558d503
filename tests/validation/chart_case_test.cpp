// Cases that name a row of a maker's chart have its values.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/validation/torch_run.hpp"
#include "core/validation/validation_case.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

using namespace meltpool;

namespace {

ValidationCase read(const std::string& joint, const std::string& keys) {
    const auto file = test::scratchFolder("chart-case") / "case.toml";
    writeTextFileAtomically(file, "name = \"one\"\nkind = \"chart_" + joint +
                                      "\"\nspacing_mm = 0.8\n[material]\nuse = \"s235\"\n[case]\n" + keys);
    return readValidationCase(file);
}

std::string faultOf(const std::string& joint, const std::string& keys) {
    try {
        read(joint, keys);
    } catch (const InputError& error) {
        return error.what();
    }
    return "read without complaint";
}

} // namespace

TEST_CASE("A case has the middle values of its chart's row", "[validation][chart]") {
    const ValidationCase butt = read("butt", "row = \"OTC-BC5\"\nwire_diameter_mm = 1.2\n");
    CHECK(butt.number("thickness_mm") == Approx(3.2));
    CHECK(butt.number("gap_mm") == Approx(1.1));
    CHECK(butt.number("voltage") == Approx(20));
    CHECK(butt.number("current_a") == Approx(140));
    CHECK(butt.number("speed_mm_s") == Approx(7.5));
    CHECK(butt.number("leg_mm") == 0);
    CHECK(butt.word("gas") == "co2");
    CHECK(butt.word("position").empty());
    const ValidationCase fed = read("lap", "row = \"LG-3.4-1.1\"\n");
    CHECK(fed.number("wire_diameter_mm") == Approx(1.1));
    CHECK(fed.number("wire_feed_m_min") == Approx(3.2));
    CHECK(fed.number("ctwd_mm") == Approx(11.5));
    CHECK(fed.number("leg_mm") == Approx(3.2));
    CHECK(read("tee", "row = \"OTC-HF7\"\n").number("leg_mm") == Approx(5)); // the least that 5 to 6 mm call for
}

TEST_CASE("A row without wire has its electrode and rod", "[validation][chart]") {
    const ValidationCase tungsten = read("tee", "row = \"AP-Tst3.2\"\nspeed_mm_s = 1.2\n");
    CHECK(tungsten.process == "gtaw");
    CHECK(tungsten.number("electrode_diameter_mm") == Approx(2.4));
    CHECK(tungsten.number("rod_diameter_mm") == Approx(2.4));
    CHECK(tungsten.number("current_a") == Approx(95));
    CHECK(tungsten.number("wire_diameter_mm") == 0);
    CHECK(tungsten.word("gas").empty());
    const ValidationCase covered = read("tee", "row = \"SMM-E7018-3.2-2F\"\nthickness_mm = 6\n");
    CHECK(covered.process == "smaw");
    CHECK(covered.word("electrode") == "e7018");
    CHECK(covered.number("electrode_diameter_mm") == Approx(3.2));
    CHECK(covered.number("leg_mm") == Approx(5));
    CHECK(covered.number("voltage") == 0); // the machine holds the current
}

TEST_CASE("A case's own values go before those of its row", "[validation][chart]") {
    const ValidationCase own = read("tee", "row = \"OTC-HF5\"\nwire_diameter_mm = 1\nvoltage = 25\ngas = \"ar_co2\"\n"
                                           "position = \"3F\"\n");
    CHECK(own.number("voltage") == 25);
    CHECK(own.number("current_a") == Approx(150));
    CHECK(own.word("gas") == "ar_co2");
    CHECK(own.word("position") == "3F");
}

TEST_CASE("A row's joint lies as the row says", "[validation][chart]") {
    CHECK(read("tee", "row = \"OTC-FF5\"\nwire_diameter_mm = 1.2\n").word("position") == "1F");
    CHECK(read("tee", "row = \"OTC-HF5\"\nwire_diameter_mm = 1.2\n").word("position").empty());
    CHECK(read("lap", "row = \"OTC-LAP5\"\nwire_diameter_mm = 1.2\n").word("position").empty());
}

TEST_CASE("A row that does not fit the case is refused", "[validation][chart]") {
    CHECK_THAT(faultOf("tee", "row = \"OTC-XX\"\n"), test::containsText("no chart has the row 'OTC-XX'"));
    CHECK_THAT(faultOf("tee", "row = \"OTC-LAP5\"\n"), test::containsText("another joint than chart_tee"));
    CHECK_THAT(
        faultOf("tee", "process = \"smaw\"\ncurrent_a = 120\nspeed_mm_s = 3\nthickness_mm = 6\nelectrode = \"e9\"\n"),
        test::containsText("electrode: is 'e9'; expected e6013, e7018 or e6010"));
    CHECK_THAT(faultOf("tee", "process = \"saw\"\ncurrent_a = 120\nspeed_mm_s = 3\nthickness_mm = 6\n"),
               test::containsText("expected gmaw, gtaw or smaw"));
    const std::string plain = "speed_mm_s = 3\nthickness_mm = 6\n";
    CHECK_THAT(faultOf("tee", plain + "current_a = 120\n"),
               test::containsText("expected a row, a wire, or the process"));
    CHECK_THAT(faultOf("tee", plain + "process = \"smaw\"\npower_w = 3000\nelectrode = \"e6013\"\n"
                                      "electrode_diameter_mm = 3.2\n"),
               test::containsText("expected the current of the covered electrode"));
    CHECK_THAT(faultOf("tee", plain + "process = \"gtaw\"\ncurrent_a = 120\nelectrode = \"e6013\"\n"),
               test::containsText("electrode: is of no use to gtaw"));
    CHECK_THAT(faultOf("tee", plain + "process = \"gtaw\"\ncurrent_a = 120\nvoltage_offset_v = -4\n"),
               test::containsText("voltage_offset_v: is of no use to gtaw"));
    CHECK_THAT(faultOf("tee", "row = \"OTC-HF7\"\nrod_diameter_mm = 2.4\n"),
               test::containsText("rod_diameter_mm: is of no use to gmaw"));
    CHECK_THAT(faultOf("tee", "row = \"AP-Tst3.2\"\nspeed_mm_s = 1.2\ngas = \"co2\"\n"),
               test::containsText("a gmaw arc"));
    CHECK_THAT(faultOf("tee", "row = \"AP-Tst3.2\"\nspeed_mm_s = 1.2\nelectrode_diameter_mm = 4\n"),
               test::containsText("electrode_diameter_mm: is not the row's; expected 2.4"));
    CHECK_THAT(faultOf("tee", "row = \"OTC-HF5\"\n"), test::containsText("expected the diameter of the wire in mm"));
    CHECK_THAT(faultOf("tee", "row = \"OTC-HF5\"\nwire_diameter_mm = 1.6\n"),
               test::containsText("expected 0.9 to 1.2"));
    CHECK_THAT(faultOf("tee", "row = \"OTC-HF7\"\ngas = \"air\"\n"),
               test::containsText("gas: is 'air'; expected ar_co2"));
    CHECK_THAT(faultOf("tee", "row = \"OTC-HF7\"\nshort_circuits = \"soft\"\n"),
               test::containsText("short_circuits: is 'soft'; expected ordinary or controlled"));
    CHECK_THAT(faultOf("tee", "row = \"AP-Tst3.2\"\nspeed_mm_s = 1.2\nshort_circuits = \"controlled\"\n"),
               test::containsText("and a gmaw arc"));
    CHECK_THAT(faultOf("butt", "row = \"OTC-BC5\"\nwire_diameter_mm = 1.2\nposition = \"1F\"\n"),
               test::containsText("position: is '1F'; expected one of"));
}

TEST_CASE("A case's machine has its kind of short circuits, ordinary ones without it", "[validation]") {
    const std::string row = "row = \"OTC-HF7\"\n";
    const auto kindOf = [&](const std::string& more) {
        return static_cast<ShortCircuitKind>(caseProcess(read("tee", row + more)).of<Gmaw>().shortCircuits);
    };
    CHECK(kindOf("") == ShortCircuitKind::ordinary);
    CHECK(kindOf("short_circuits = \"ordinary\"\n") == ShortCircuitKind::ordinary);
    CHECK(kindOf("short_circuits = \"controlled\"\n") == ShortCircuitKind::controlled);
}

TEST_CASE("Every shipped case of a chart reads", "[validation][chart]") {
    for (const char* folder : {"charts", "charts_hand"})
        for (const auto& file : validationCaseFiles(test::testFolder() / "validation" / folder)) {
            INFO(file);
            const ValidationCase one = readValidationCase(file);
            CHECK(one.number("thickness_mm") / (1e3 * one.spacing) > 3.99);
            CHECK(one.number("current_a") > 0);
        }
}
