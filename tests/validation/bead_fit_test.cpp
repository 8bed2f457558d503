// How efficiency, arc radius and the liquid's conductivity of the measured beads were found: the grid point that fits
// three of the nine runs best. Prints what it finds; `test_metal "The measured beads*"` runs it alone.
#include "core/validation/validation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace meltpool;

namespace {

struct Guess {
    double efficiency, sigma, factor; // of the power; mm; of the liquid's conductivity
};

bool isFitted(const ValidationCase& bead) {
    return bead.name.find("(fitted)") != std::string::npos;
}

/// The nine measured beads; Park's, with wire, is not one of them.
std::vector<ValidationCase> measuredBeads() {
    std::vector<ValidationCase> beads;
    for (const auto& file : validationCaseFiles(test::testFolder() / "validation" / "cases"))
        if (const ValidationCase one = readValidationCase(file);
            one.kind->name == "bead_on_plate" && one.number("wire_feed_m_min") == 0)
            beads.push_back(one);
    return beads;
}

/// Errors of width and penetration, as shares.
struct Errors {
    double width, penetration;
};

Errors errorsOf(ValidationCase bead, const Guess& guess) {
    bead.numbers["efficiency"] = guess.efficiency;
    bead.numbers["arc_sigma_mm"] = guess.sigma;
    bead.numbers["liquid_conductivity_factor"] = guess.factor;
    const ValidationResult result = runValidationCase(bead, test::shaders());
    return {result.numbers[0].errorPercent / 100, result.numbers[1].errorPercent / 100};
}

/// Mean square of the errors of the three fitted beads.
double misfit(const std::vector<ValidationCase>& beads, const Guess& guess) {
    double sum = 0;
    for (const ValidationCase& bead : beads)
        if (isFitted(bead)) {
            const Errors errors = errorsOf(bead, guess);
            sum += (errors.width * errors.width + errors.penetration * errors.penetration) / 6;
        }
    return sum;
}

Guess bestOnGrid(const std::vector<ValidationCase>& beads) {
    Guess best{};
    double least = INFINITY;
    for (const double efficiency : {0.85, 0.9, 0.95, 1.0})
        for (const double sigma : {1.5, 1.75, 2.0})
            for (const double factor : {1.5, 2.0, 3.0}) {
                const Guess guess{efficiency, sigma, factor};
                const double now = misfit(beads, guess);
                std::printf("efficiency %.2f  arc sigma %.2f mm  conductivity x %.1f: rms error of the three %.1f %%\n",
                            efficiency, sigma, factor, 100 * std::sqrt(now));
                if (now >= least) continue;
                least = now;
                best = guess;
            }
    return best;
}

} // namespace

TEST_CASE("The measured beads' parameters come out of a fit to three of them", "[validation][long]") {
    const auto beads = measuredBeads();
    REQUIRE(beads.size() == 9);
    CHECK(std::count_if(beads.begin(), beads.end(), isFitted) == 3);
    const Guess best = bestOnGrid(beads);
    double width = 0, penetration = 0;
    for (const ValidationCase& bead : beads) {
        // What ships is what the fit finds, in all nine alike.
        CHECK(bead.number("efficiency") == Approx(best.efficiency));
        CHECK(bead.number("arc_sigma_mm") == Approx(best.sigma));
        CHECK(bead.number("liquid_conductivity_factor") == Approx(best.factor));
        const Errors errors = errorsOf(bead, best);
        std::printf("%-42s width %5.1f %%  penetration %5.1f %%\n", bead.name.c_str(), 100 * errors.width,
                    100 * errors.penetration);
        if (isFitted(bead)) continue;
        CHECK(errors.width <= 0.25);
        CHECK(errors.penetration <= 0.40);
        width += errors.width / 6;
        penetration += errors.penetration / 6;
    }
    std::printf("the six predicted on average: width %.1f %%, penetration %.1f %%\n", 100 * width, 100 * penetration);
    CHECK(width <= 0.10);
    CHECK(penetration <= 0.15);
}
