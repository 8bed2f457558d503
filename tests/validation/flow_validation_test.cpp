// The shipped validation cases of the flow.
#include "core/validation/validation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

namespace meltpool {

namespace {

ValidationResult runShipped(const std::string& name) {
    const auto file = test::testFolder() / "validation" / "cases" / (name + ".toml");
    return runValidationCase(readValidationCase(file), test::shaders());
}

} // namespace

TEST_CASE("shipped flow cases that are quick pass", "[validation]") {
    const std::string name = GENERATE("droplet_oscillation", "poiseuille");
    const ValidationResult result = runShipped(name);
    INFO(validationText(result));
    CHECK(result.passed());
    CHECK(result.steps > 0);
}

TEST_CASE("shipped flow cases that take their time pass", "[validation][long]") {
    const std::string name = GENERATE("droplet_pressure", "sessile_drop", "hydrostatic");
    const ValidationResult result = runShipped(name);
    INFO(validationText(result));
    CHECK(result.passed());
    WARN(validationText(result));
}

TEST_CASE("the dam's front is near the measured one", "[validation][long]") {
    const ValidationResult result = runShipped("dam_break");
    WARN(validationText(result));
    CHECK(result.numbers.size() == 15); // all fronts, and their mean error
    CHECK(result.passed());
}

} // namespace meltpool
