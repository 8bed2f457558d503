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
    return test::testFolder() / "validation" / "cases" / (name + ".toml");
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
    const auto results = nlohmann::json::parse(readTextFile(file));
    CHECK(results["passed"] == true);
    REQUIRE(results["cases"].size() == 2);
    CHECK(results["cases"][0]["kind"] == "conduction_step");
    CHECK(results["cases"][1]["numbers"][0]["name"] == "front_mm");
    CHECK(results["cases"][1]["numbers"][0]["reference"].get<double>() == Approx(4.543).margin(1e-3));
}

TEST_CASE("validate runs the cases of a folder, by name", "[app]") {
    const auto folder = test::scratchFolder("validate"), cases = folder / "cases";
    std::filesystem::create_directory(cases);
    for (const std::string name : {"stefan_two_phase", "conduction_step"})
        std::filesystem::copy_file(shippedCase(name), cases / (name + ".toml"));
    writeTextFileAtomically(cases / "notes.txt", "no case");
    const auto file = folder / "out.json";
    const auto outcome =
        runMeltpool("validate" + quoted(cases) + quoted(shippedCase("conduction_flux")) + "--json" + quoted(file));
    CHECK(outcome.code == 0);
    const auto results = nlohmann::json::parse(readTextFile(file));
    REQUIRE(results["cases"].size() == 3);
    CHECK(results["cases"][0]["kind"] == "conduction_step");
    CHECK(results["cases"][1]["kind"] == "stefan_two_phase");
    CHECK(results["cases"][2]["kind"] == "conduction_flux");
    std::filesystem::create_directory(folder / "none");
    const auto empty = runMeltpool("validate" + quoted(folder / "none"));
    CHECK(empty.code == 2);
    CHECK_THAT(empty.errors, containsText("holds no validation case; expected files that end in .toml"));
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

TEST_CASE("validate keeps what it has when a case ends early, and goes on with the others", "[app]") {
    const auto folder = test::scratchFolder("validate");
    std::string text = readTextFile(shippedCase("bead_gmaw_park"));
    text.replace(text.find("wire_diameter_mm = 1.0"), 22, "current_a = 100\narc_length_mm = 25"); // too long for an arc
    text.replace(text.find("wire_feed_m_min = 7"), 19, "");
    text.replace(text.find("height_mm = 2.2"), 15, "");
    text.replace(text.find("section_mm2 = 9.16"), 18, "");
    for (const std::string name : {"height_mm_tolerance_percent = 20", "section_mm2_tolerance_percent = 10"})
        text.replace(text.find(name), name.size(), "");
    const auto weak = folder / "weak arc.toml";
    writeTextFileAtomically(weak, text);
    const auto file = folder / "out.json";
    const auto outcome = runMeltpool("validate" + quoted(shippedCase("conduction_step")) + quoted(weak) +
                                     quoted(shippedCase("conduction_flux")) + "--json" + quoted(file));
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.errors, containsText("weak arc.toml: [case]: the arc burned for less than half of its time"));
    CHECK_THAT(outcome.output, containsText("2 of 3 cases passed"));
    const auto results = nlohmann::json::parse(readTextFile(file));
    REQUIRE(results["cases"].size() == 3);
    CHECK(results["complete"] == true);
    CHECK(results["passed"] == false);
    CHECK(results["cases"][0]["passed"] == true);
    CHECK(results["cases"][1]["passed"] == false);
    CHECK_THAT(results["cases"][1]["error"].get<std::string>(), containsText("burned for less than half"));
    CHECK(results["cases"][1]["numbers"][0]["name"] == "current_a"); // results of finished cases
    CHECK(results["cases"][2]["passed"] == true);
}

TEST_CASE("validate says where its JSON cannot be written, and puts no file in a device's place", "[app]") {
    const std::string words = "validate" + quoted(shippedCase("conduction_step")) + "--json ";
    const auto full = runMeltpool(words + "/dev/full");
    CHECK(full.code == 1);
    CHECK_THAT(full.errors, containsText("/dev/full: cannot be written to its end"));
    CHECK(std::filesystem::is_character_file("/dev/full"));
    const auto nowhere = runMeltpool(words + "/no/such/folder/out.json");
    CHECK(nowhere.code == 2);
    CHECK_THAT(nowhere.errors, containsText("/no/such/folder/out.json: cannot be written"));
    CHECK_THAT(nowhere.output, !containsText("pass")); // no case has run
}
