// Every shipped validation case: it passes, or known_failures.txt names it.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/validation/validation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/validation/known_failures.hpp"

#include <cstdio>
#include <set>

using namespace meltpool;
using namespace meltpool::test;

namespace {

namespace fs = std::filesystem;

/// Cases of at most a few seconds; the others belong to the long tests.
const std::set<std::string> kQuick{
    "conduction_step",  "conduction_flux",      "stefan_one_phase",   "stefan_two_phase", "energy",
    "energy_insulated", "energy_weld",          "poiseuille",         "bead_29v_400a_12", "droplet_oscillation",
    "bead_gmaw_park",   "rosenthal_thick_fast", "rosenthal_thin_fast"};

fs::path caseFolder() {
    return testFolder() / "validation" / "cases";
}

KnownFailures shippedFailures() {
    return readKnownFailures(testFolder() / "validation" / "known_failures.txt", caseFolder());
}

/// Runs a case as `meltpool validate` does: a case that ends early has failed, with the reason in `error`.
ValidationResult runShipped(const std::string& name) {
    ValidationResult result;
    try {
        runValidationCase(readValidationCase(caseFolder() / (name + ".toml")), shaders(), result);
    } catch (const std::exception& error) {
        result.error = error.what();
    }
    return result;
}

void checkShipped(const std::string& name, const KnownFailures& known) {
    const ValidationResult result = runShipped(name);
    if (!result.passed() && known.contains(name))
        std::printf("known failure: %s: %s\n%s", name.c_str(), known.at(name).c_str(), validationText(result).c_str());
    INFO(validationText(result));
    CHECK(surpriseOf(name, result.passed(), known) == "");
    if (!result.error.empty()) return;
    CHECK(result.steps > 0);
    CHECK_FALSE(result.numbers.empty());
    if (name == "dam_break") CHECK(result.numbers.size() == 15); // all fronts, and their mean error
}

} // namespace

TEST_CASE("Quick shipped cases pass, or are known to fail", "[validation][shipped]") {
    const KnownFailures known = shippedFailures();
    for (const std::string& name : kQuick)
        checkShipped(name, known);
}

TEST_CASE("All other shipped cases pass, or are known to fail", "[validation][shipped][long]") {
    const KnownFailures known = shippedFailures();
    for (const fs::path& file : validationCaseFiles(caseFolder()))
        if (!kQuick.contains(file.stem().string())) checkShipped(file.stem().string(), known);
}

TEST_CASE("A case that fails unexpectedly is told, and so is one that passes unnoticed", "[shipped]") {
    const KnownFailures known{{"bead", "too little heat"}};
    CHECK(surpriseOf("bead", false, known) == "");
    CHECK(surpriseOf("dam", true, known) == "");
    CHECK_THAT(surpriseOf("bead", true, known), containsText("bead passes, but"));
    CHECK_THAT(surpriseOf("bead", true, known), containsText("too little heat"));
    CHECK(surpriseOf("dam", false, known) == "dam fails and is no known failure");
}

TEST_CASE("The list of known failures names cases with their reasons, and its faults are told by line", "[shipped]") {
    const fs::path folder = scratchFolder("known"), file = folder / "known.txt";
    writeTextFileAtomically(folder / "bead.toml", "");
    const auto reading = [&](const std::string& text) {
        writeTextFileAtomically(file, text);
        return readKnownFailures(file, folder);
    };
    CHECK(reading("# nothing fails\n\n").empty());
    const KnownFailures known = reading("# one fails\nbead: too little heat # at 1 mm\n");
    CHECK(known == KnownFailures{{"bead", "too little heat"}});
    const auto told = [&](const std::string& text) -> std::string {
        try {
            reading(text);
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    };
    CHECK_THAT(told("\nbead\n"), containsText("known.txt:2: expected NAME: REASON"));
    CHECK_THAT(told("bead: \n"), containsText("known.txt:1: expected NAME: REASON"));
    CHECK_THAT(told("dam: no such case\n"), containsText("known.txt:1: there is no case 'dam'"));
    CHECK_THAT(told("bead: hot\nbead: cold\n"), containsText("known.txt:2: 'bead' stands twice"));
}
