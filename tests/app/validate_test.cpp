// `meltpool validate`: its table, its JSON, its exit codes.
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

std::filesystem::path shippedCase(const std::string& name) {
    return test::testFolder() / "validation" / (name + ".toml");
}

std::string quoted(const std::filesystem::path& file) {
    return " '" + file.string() + "' ";
}

} // namespace

TEST_CASE("validate prints and keeps every number", "[app]") {
    const auto folder = test::scratchFolder("validate");
    const auto file = folder / "out.json";
    const auto outcome = runMeltpool("validate" + quoted(shippedCase("conduction_step")) +
                                     quoted(shippedCase("stefan_two_phase")) + "--json" + quoted(file));
    INFO(outcome.errors);
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.output, containsText("temperature_at_2mm_k"));
    CHECK_THAT(outcome.output, containsText("2 of 2 cases passed"));
    const auto json = nlohmann::json::parse(readTextFile(file));
    CHECK(json["passed"] == true);
    REQUIRE(json["cases"].size() == 2);
    CHECK(json["cases"][0]["kind"] == "conduction_step");
    CHECK(json["cases"][1]["numbers"][0]["name"] == "front_mm");
    CHECK(json["cases"][1]["numbers"][0]["reference"].get<double>() == Approx(4.543).margin(1e-3));
}

TEST_CASE("validate ends with 1 when a case fails and with 2 when a file has a fault", "[app]") {
    const auto folder = test::scratchFolder("validate");
    std::string text = readTextFile(shippedCase("conduction_step"));
    const auto change = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        changed.replace(changed.find(from), from.size(), to);
        const auto file = folder / "changed.toml";
        writeTextFileAtomically(file, changed);
        return runMeltpool("validate" + quoted(file));
    };
    const auto strict = change("tolerance_percent = 0.5", "tolerance_percent = 0");
    CHECK(strict.code == 1);
    CHECK_THAT(strict.output, containsText("FAIL"));
    const auto wrong = change("spacing_mm = 1", "spacing_mm = \"one\"");
    CHECK(wrong.code == 2);
    CHECK_THAT(wrong.errors, containsText("changed.toml:4: spacing_mm: expected a number"));
    CHECK(runMeltpool("validate missing.toml").code == 2);
}
