// Cases that name a row of a maker's chart have its values.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
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
    CHECK_THAT(faultOf("butt", "row = \"PT-butt1.5\"\n"), test::containsText("a row for gmaw"));
    CHECK_THAT(faultOf("tee", "row = \"OTC-HF5\"\n"), test::containsText("a joint needs filler"));
    CHECK_THAT(faultOf("tee", "row = \"OTC-HF5\"\nwire_diameter_mm = 1.6\n"),
               test::containsText("expected 0.9 to 1.2"));
    CHECK_THAT(faultOf("tee", "row = \"OTC-HF7\"\ngas = \"air\"\n"),
               test::containsText("gas: is 'air'; expected ar_co2"));
    CHECK_THAT(faultOf("butt", "row = \"OTC-BC5\"\nwire_diameter_mm = 1.2\nposition = \"1F\"\n"),
               test::containsText("position: is '1F'; expected one of"));
}

TEST_CASE("Every shipped case of a chart reads", "[validation][chart]") {
    for (const auto& file : validationCaseFiles(test::testFolder() / "validation" / "charts")) {
        INFO(file);
        const ValidationCase one = readValidationCase(file);
        CHECK(one.number("thickness_mm") / (1e3 * one.spacing) > 3.99);
        CHECK(one.number("current_a") > 0);
    }
}
