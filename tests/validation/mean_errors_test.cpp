// Mean errors over many cases.
#include "core/validation/mean_errors.hpp"
#include "tests/support/catch.hpp"

#include <cmath>

using namespace meltpool;

namespace {

ValidationNumber measured(const char* name, double reference, double ours) {
    return {name, "measured", reference, ours, 100 * std::abs(ours - reference) / reference, 10, true, {}};
}

ValidationNumber told(const char* name) {
    return {name, "ours", 0, 7, 0, 0, true, {}};
}

ValidationResult result(const char* name, std::vector<ValidationNumber> numbers) {
    ValidationResult made;
    made.name = name;
    made.numbers = std::move(numbers);
    return made;
}

} // namespace

TEST_CASE("Mean errors of what several cases measured, the worst by name", "[validation]") {
    const std::vector results{result("one", {measured("width_mm", 10, 11), measured("height_mm", 2, 2), told("steps")}),
                              result("two", {measured("width_mm", 5, 4), told("steps")}),
                              result("three", {measured("height_mm", 4, std::nan("")), measured("depth_mm", 3, 3)})};
    const std::vector<MeanError> errors = meanErrors(results);
    REQUIRE(errors.size() == 2); // the depth has a single measurement
    CHECK(errors[0].name == "width_mm");
    CHECK(errors[0].count == 2);
    CHECK(errors[0].percent == Approx(15));
    CHECK(errors[0].bias == Approx(-5));
    CHECK(errors[0].difference == Approx(1));
    CHECK(errors[0].worstPercent == Approx(20));
    CHECK(errors[0].worstCase == "two");
    CHECK(errors[1].name == "height_mm");
    CHECK(errors[1].percent == Approx(50)); // a case without a result counts as 100 % off
    CHECK(errors[1].worstDifference == Approx(4));
    CHECK(errors[1].worstCase == "three");
    CHECK(meanErrorsText(errors) ==
          "mean error of 2 measured width_mm: 15.0 % (1.00), on average -5.0 %; worst 20.0 % in two\n"
          "mean error of 2 measured height_mm: 50.0 % (2.00), on average -50.0 %; worst 100.0 % in three\n");
    CHECK(meanErrors({}).empty());
    CHECK(meanErrorsText({}).empty());
}
