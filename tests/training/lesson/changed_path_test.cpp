// A person's own path with one change: nothing else changes, and an electrode is followed.
#include "core/training/lesson/changed_path.hpp"
#include "core/weld/torch/hand_tremor.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using namespace meltpool;

namespace {

constexpr double kStep = 0.002;
constexpr double kDegree = std::numbers::pi / 180;

Seam plateSeam() {
    return Seam::line({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, -0.05, 0.05);
}

/// Returns 4 s at 5 mm/s along +x, 3 mm over a plate; the arc burns from 1 s on.
std::vector<AttemptStep> straightSteps() {
    std::vector<AttemptStep> steps(2000);
    double time = 0;
    for (AttemptStep& step : steps) {
        time += kStep;
        step.torch.time = time;
        step.torch.tip = {-0.01f + 0.005f * static_cast<float>(time), 0.003f, 0};
        step.torch.orientation = heldOrientation(90 * kDegree, 10 * kDegree, {1, 0, 0});
        step.torch.trigger = 1;
        step.burned = time > 1;
    }
    return steps;
}

double workOf(const TorchSample& torch) {
    const glm::vec3 axis = torch.axis();
    return std::atan2(static_cast<double>(-axis.z), static_cast<double>(-axis.y));
}

double leanOf(const TorchSample& torch) {
    return std::asin(static_cast<double>(torch.axis().x));
}

glm::dvec3 footOf(const TorchSample& torch) {
    return meltpool::footOf(plateSeam(), glm::dvec3(torch.tip), glm::normalize(glm::dvec3(torch.axis())));
}

} // namespace

TEST_CASE("a path with nothing changed has its own bits at every step", "[training][comparison]") {
    const auto steps = straightSteps();
    const ChangedPath path(steps, plateSeam(), {});
    CHECK(path.duration() == steps.back().torch.time);
    for (const AttemptStep& step : steps) {
        const TorchSample same = path.sample(step.torch.time, step.burntOff);
        REQUIRE(same.tip == step.torch.tip);
        REQUIRE(same.orientation == step.torch.orientation);
        REQUIRE(same.trigger == step.torch.trigger);
        REQUIRE(same.time == step.torch.time);
    }
}

TEST_CASE("speed, length and angles change what they name and nothing else", "[training][comparison]") {
    const auto steps = straightSteps();
    const auto changed = [&](const PathChange& change, double time) {
        return ChangedPath(steps, plateSeam(), change).sample(time, 0);
    };
    const TorchSample plain = changed({}, 3);

    CHECK(glm::distance(changed({.speed = 0.5}, 6).tip, plain.tip) < 1e-6f);
    CHECK(ChangedPath(steps, plateSeam(), {.speed = 0.5}).duration() == Approx(8));

    const TorchSample longer = changed({.farther = 2e-3}, 3);
    CHECK(glm::distance(longer.tip, plain.tip - 0.002f * plain.axis()) < 1e-6f);
    CHECK(longer.orientation == plain.orientation);
    // The strike does not move: the length changes in the half second after it.
    CHECK(changed({.farther = 2e-3}, 0.9).tip == changed({}, 0.9).tip);
    const float taken = glm::distance(changed({.farther = 2e-3}, 1.25).tip, changed({}, 1.25).tip);
    CHECK(taken > 0.0005f);
    CHECK(taken < 0.0015f);

    const TorchSample pushed = changed({.travelAngle = 15 * kDegree}, 3);
    CHECK((leanOf(pushed) - leanOf(plain)) / kDegree == Approx(15).epsilon(1e-3));
    CHECK(workOf(pushed) == Approx(workOf(plain)).margin(1e-4));
    CHECK(glm::distance(footOf(pushed), footOf(plain)) < 1e-6);
    CHECK(glm::distance(glm::dvec3(pushed.tip), footOf(pushed)) ==
          Approx(glm::distance(glm::dvec3(plain.tip), footOf(plain))).epsilon(1e-3));

    const TorchSample leaned = changed({.workAngle = -20 * kDegree}, 3);
    CHECK((workOf(leaned) - workOf(plain)) / kDegree == Approx(-20).epsilon(1e-3));
    CHECK(leanOf(leaned) == Approx(leanOf(plain)).margin(1e-4));
    CHECK(glm::distance(footOf(leaned), footOf(plain)) < 1e-6);
}

TEST_CASE("a push is a push whichever way the seam is welded", "[training][comparison]") {
    auto steps = straightSteps();
    for (AttemptStep& step : steps)
        step.torch.tip.x = -step.torch.tip.x; // the torch drags now
    const ChangedPath path(steps, plateSeam(), {.travelAngle = 15 * kDegree});
    CHECK((leanOf(path.sample(3, 0)) - leanOf(steps[1500].torch)) / kDegree == Approx(-15).epsilon(1e-3));
}

TEST_CASE("an electrode that burns off otherwise is followed, so that its arc stays as long",
          "[training][comparison]") {
    auto steps = straightSteps();
    for (AttemptStep& step : steps) // the electrode burns off at 2 mm/s, and the hand follows it down
        step.burntOff = step.burned ? 0.002 * (step.torch.time - 1) : 0;
    const auto endOf = [](const TorchSample& torch, double burntOff) {
        return glm::dvec3(torch.tip) - burntOff * glm::dvec3(torch.axis());
    };
    const ChangedPath path(steps, plateSeam(), {.speed = 0.5});
    const TorchSample then = steps[1499].torch, now = path.sample(then.time * 2, 0.009);
    CHECK(glm::distance(endOf(now, 0.009), endOf(then, steps[1499].burntOff)) < 1e-6);
    CHECK(glm::distance(now.tip, then.tip) > 0.003f);
}

TEST_CASE("a still hand has no tremor, and keeps its weave", "[training][comparison]") {
    auto steps = straightSteps();
    const HandTremor tremor(3);
    const auto weave = [](double time) { return 0.002 * std::sin(2 * std::numbers::pi * 1.5 * time); };
    for (AttemptStep& step : steps) {
        step.torch.tip.z += static_cast<float>(weave(step.torch.time));
        tremor.shake(step.torch, step.torch.time, HandTremor::kPlace, HandTremor::kAngle);
    }
    const auto offOf = [&](double stillness) {
        const ChangedPath path(steps, plateSeam(), {.stillness = stillness});
        double square = 0;
        int count = 0;
        for (const AttemptStep& step : steps) {
            const double time = step.torch.time;
            if (time < 0.5 || time > 3.5) continue;
            const TorchSample torch = path.sample(time, 0);
            square += std::pow(static_cast<double>(torch.tip.z) - weave(time), 2) +
                      std::pow(static_cast<double>(torch.tip.y) - 0.003, 2);
            ++count;
        }
        return std::sqrt(square / count / 2);
    };
    const double before = offOf(0);
    CHECK(before > 2e-4);
    CHECK(before < 4e-4);
    CHECK(offOf(1) < 0.1 * before);
    CHECK(offOf(0.5) == Approx(0.5 * before).epsilon(0.1));
}
