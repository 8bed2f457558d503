// Cases too large for the machine or too small for their spacing, refused before any allocation.
#include "core/base/error.hpp"
#include "core/base/memory.hpp"
#include "core/validation/validation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>

using namespace meltpool;

namespace {

ValidationCase shipped(const std::string& name, double spacing) {
    ValidationCase result = readValidationCase(test::testFolder() / "validation" / "cases" / (name + ".toml"));
    result.spacing = spacing;
    return result;
}

std::string faultOf(const ValidationCase& from) {
    try {
        runValidationCase(from, test::shaders());
    } catch (const InputError& error) {
        return error.what();
    }
    return "run without complaint";
}

} // namespace

TEST_CASE("A case that is too large says how large before it allocates", "[validation]") {
    const auto before = availableMemory();
    const std::string name = GENERATE("rosenthal_thick", "energy_weld", "bead_gmaw_park", "bead_29v_400a_12",
                                      "cavity_gallium", "droplet_pressure", "sessile_drop");
    INFO(name);
    CHECK_THAT(faultOf(shipped(name, 5e-6)), test::containsText("million particles"));
    if (before) CHECK(*availableMemory() > *before / 2);
}

TEST_CASE("A case of too many steps or too few particles says so", "[validation]") {
    CHECK_THAT(faultOf(shipped("conduction_step", 1e-6)), test::containsText("million steps"));
    const std::string name = GENERATE("energy", "bead_gmaw_park", "cavity_gallium", "droplet_pressure",
                                      "droplet_oscillation", "sessile_drop", "hydrostatic", "dam_break", "poiseuille");
    INFO(name);
    CHECK_THAT(faultOf(shipped(name, 0.05)), test::containsText("too little for particles of 50 mm"));
}

TEST_CASE("What is no whole number of spacings is met exactly", "[validation]") {
    ValidationCase plates = shipped("poiseuille", 1e-3);
    plates.numbers["gap_mm"] = 6.4;
    plates.time = 0.05;
    const ValidationResult result = runValidationCase(plates, test::shaders());
    INFO(validationText(result));
    CHECK(result.passed());
    CHECK(result.spacing == Approx(6.4e-3 / 6));
}

TEST_CASE("A bead's deposit is its wire's metal on a short plate too", "[validation]") {
    ValidationCase bead = shipped("bead_gmaw_park", 1e-3);
    bead.measured.clear();
    bead.lists["plate_mm"] = {36, 5, 20};
    const ValidationResult result = runValidationCase(bead, test::shaders());
    INFO(validationText(result));
    CHECK(result.passed());
    const auto deposited = std::find_if(result.numbers.begin(), result.numbers.end(),
                                        [](const ValidationNumber& n) { return n.name == "deposited_mm2"; });
    REQUIRE(deposited != result.numbers.end());
    CHECK(deposited->origin == "exact");
    CHECK(deposited->reference == Approx(9.163).epsilon(0.03)); // feed alone; the wire burns back by a few millimetres
}
