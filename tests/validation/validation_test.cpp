// Convergence of fronts and fields with the spacing, and closed forms for materials and sizes other than the shipped
// ones.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/validation/validation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>

using namespace meltpool;

namespace {

ValidationCase shipped(const std::string& name, double spacing) {
    ValidationCase result = readValidationCase(test::testFolder() / "validation" / "cases" / (name + ".toml"));
    result.spacing = spacing;
    return result;
}

} // namespace

TEST_CASE("A moving source's field is right beyond three coarse cells too", "[validation]") {
    const ValidationResult result = runValidationCase(shipped("rosenthal_thick", 2e-3), test::shaders());
    INFO(validationText(result));
    CHECK(result.numbers[0].errorPercent < 3);   // at 10 mm behind the source
    CHECK(result.numbers[1].errorPercent < 1.5); // at 20 mm behind the source
}

TEST_CASE("Errors shrink with the spacing", "[validation]") {
    const std::string name = GENERATE("conduction_step", "stefan_one_phase", "stefan_two_phase");
    const auto error = [&](double spacing) {
        const ValidationResult result = runValidationCase(shipped(name, spacing), test::shaders());
        double worst = 0;
        for (const ValidationNumber& n : result.numbers)
            worst = std::max(worst, n.errorPercent);
        return worst;
    };
    const double coarse = error(1e-3), middle = error(0.5e-3), fine = error(0.25e-3);
    INFO(name << ": " << coarse << " % at 1 mm, " << middle << " % at 0.5 mm, " << fine << " % at 0.25 mm");
    CHECK(middle < 0.7 * coarse);
    CHECK(fine < 0.7 * middle);
}

TEST_CASE("A wrong reference is found out", "[validation]") {
    ValidationCase wrong = shipped("conduction_step", 1e-3);
    wrong.numbers["initial_temperature_k"] = 350; // the closed form adapts, a fixed number does not
    ValidationResult result = runValidationCase(wrong, test::shaders());
    CHECK(result.passed());
    result.compareExact(wrong, "temperature", 1225.8, result.numbers[0].ours);
    CHECK_FALSE(result.passed());
    result = {};
    result.compareExact(wrong, "nothing", 1, std::nan(""));
    CHECK_FALSE(result.passed());
}

TEST_CASE("Closed forms hold for shipped materials with tables and through their melting point", "[validation]") {
    ValidationCase step = shipped("conduction_step", 1e-3);
    step.material = shippedMaterial(GENERATE("s235", "304", "gallium"));
    ValidationResult result = runValidationCase(step, test::shaders());
    INFO(validationText(result));
    CHECK(result.passed());
    ValidationCase flux = shipped("conduction_flux", 1e-3);
    flux.material = step.material;
    result = runValidationCase(flux, test::shaders());
    INFO(validationText(result));
    CHECK(result.passed());
}

TEST_CASE("Fronts freeze as they melt, and a mushy range counts as its middle", "[validation]") {
    ValidationCase front = shipped(GENERATE("stefan_one_phase_1mm", "stefan_two_phase_1mm"), 1e-3);
    const bool onePhase = front.kind->name == "stefan_one_phase";
    const double melted = runValidationCase(front, test::shaders()).numbers[0].ours;
    // Both phases have one material: mirrored temperatures give an equal front.
    front.numbers["wall_temperature_k"] = 2 * 1750 - front.number("wall_temperature_k");
    front.numbers["initial_temperature_k"] = 2 * 1750 - front.number("initial_temperature_k");
    ValidationResult result = runValidationCase(front, test::shaders());
    INFO(validationText(result));
    CHECK(result.passed());
    CHECK(result.numbers[0].ours == Approx(melted).epsilon(2e-3));

    ValidationCase mushy = shipped("stefan_two_phase_1mm", 1e-3);
    mushy.material = shippedMaterial("s235");
    if (onePhase) mushy.kind = front.kind;
    result = runValidationCase(mushy, test::shaders());
    INFO(validationText(result));
    CHECK(result.passed());
}

TEST_CASE("A moving source's plate has any thickness, and the case waits until its field stands still",
          "[validation]") {
    ValidationCase thin = shipped("rosenthal_thin", 1e-3);
    thin.numbers["thickness_mm"] = 1.6;
    thin.time = 0.1; // the source has moved half a cell at most
    const ValidationResult result = runValidationCase(thin, test::shaders());
    INFO(validationText(result));
    CHECK(result.passed());
    CHECK(result.numbers.back().name == "settled_after_s");
    CHECK(result.numbers.back().ours > 2);
}

TEST_CASE("Every number has a documented name, and measured values are held against any of them", "[validation]") {
    ValidationCase one = shipped(
        GENERATE("conduction_step", "stefan_two_phase_1mm", "energy_insulated", "poiseuille", "droplet_oscillation"),
        1e-3);
    const auto names = resultNames(one);
    one.measured[names.front()] = {{1e6}, 3};
    const ValidationResult result = runValidationCase(one, test::shaders());
    INFO(validationText(result));
    for (const ValidationNumber& number : result.numbers) {
        INFO(number.name);
        CHECK(std::find(names.begin(), names.end(), number.name) != names.end());
    }
    CHECK_FALSE(result.passed());
    CHECK(result.numbers[1].origin == "measured");
    CHECK(result.numbers[1].reference == 1e6);
    CHECK(result.numbers[1].ours == result.numbers[0].ours);
    CHECK_FALSE(result.numbers[1].passed);
}
