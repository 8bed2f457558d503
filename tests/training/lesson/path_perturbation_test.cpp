// Bends of a path: each changes its own quantity alone.
#include "core/training/lesson/path_perturbation.hpp"
#include "tests/support/catch.hpp"

#include <glm/gtc/quaternion.hpp>

#include <cmath>

using namespace meltpool;

namespace {

/// Returns a path straight down along +x at 5 mm/s, 3 mm over a plate.
TorchPath straightPath() {
    std::vector<TorchSample> samples(2);
    for (size_t i = 0; i < 2; ++i) {
        samples[i].time = 10.0 * static_cast<double>(i);
        samples[i].tip = {-0.025f + 0.05f * static_cast<float>(i), 0.003f, 0};
        samples[i].orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
        samples[i].trigger = 1;
    }
    return TorchPath(samples);
}

Seam plateSeam() {
    return Seam::line({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, -0.05, 0.05);
}

} // namespace

TEST_CASE("a bend in time, distance, angle and place changes that and nothing else", "[training][check]") {
    const TorchPath path = straightPath();
    const Seam seam = plateSeam();
    const TorchSample plain = path.sample(4);
    const auto bent = [&](const PathPerturbation& bend, double time) {
        return PerturbedPath(path, seam, bend).sample(time);
    };

    const TorchSample fast = bent({.time = 0.5}, 2);
    CHECK(glm::distance(fast.tip, plain.tip) < 1e-6f);
    CHECK(fast.time == 2);
    CHECK(PerturbedPath(path, seam, {.time = 0.5}).duration() == Approx(5));

    CHECK(glm::distance(bent({.farther = 7e-3}, 4).tip, plain.tip + glm::vec3(0, 0.007f, 0)) < 1e-6f);
    CHECK(glm::distance(bent({.aside = 4e-3}, 4).tip, plain.tip + glm::vec3(0, 0, 0.004f)) < 1e-6f);

    const double turn = 0.5;
    const TorchSample turned = bent({.turn = turn}, 4);
    CHECK(turned.tip.x == Approx(plain.tip.x));
    CHECK(std::hypot(turned.tip.y, turned.tip.z) == Approx(0.003).epsilon(1e-4)); // rotation about the seam
    CHECK(turned.tip.z > 0);                                                      // the handle leans to the welder
    CHECK(glm::dot(turned.axis(), plain.axis()) == Approx(std::cos(turn)).epsilon(1e-5));
    CHECK(turned.trigger == 1);
}

TEST_CASE("a tremor has its size and repeats by its seed", "[training][check]") {
    const TorchPath path = straightPath();
    const Seam seam = plateSeam();
    const PerturbedPath steady(path, seam, {}), one(path, seam, {.tremor = 1}), same(path, seam, {.tremor = 1}),
        two(path, seam, {.tremor = 2});
    double square = 0, angle = 0;
    constexpr int kSamples = 1000;
    bool differs = false;
    for (int i = 0; i < kSamples; ++i) {
        const double time = 10.0 * i / kSamples;
        const TorchSample plain = steady.sample(time), shaken = one.sample(time);
        square += std::pow(static_cast<double>(shaken.tip.y - plain.tip.y), 2);
        angle += std::pow(std::acos(std::min(1.0, static_cast<double>(glm::dot(shaken.axis(), plain.axis())))), 2);
        CHECK(shaken.tip == same.sample(time).tip);
        differs = differs || shaken.tip != two.sample(time).tip;
    }
    CHECK(std::sqrt(square / kSamples) == Approx(3e-4).epsilon(0.1));
    CHECK(std::sqrt(angle / kSamples) == Approx(0.035 * std::sqrt(2.0)).epsilon(0.1)); // sum of two axes
    CHECK(differs);
}
