// What-ifs on real metal: no change gives an equal weld, and lower speed, more current and a longer arc have their real
// effects.
#include "core/training/attempt/differences.hpp"
#include "core/training/lesson/changed_path.hpp"
#include "core/training/trainer/trainer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>

using namespace meltpool;

namespace {

constexpr double kSeconds = 2.6;

/// Returns a TIG track of 9 mm on a small plate: 0.6 s for the pool, then 5 mm/s.
Lesson smallTrack() {
    Lesson lesson = findLesson("gtaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 18;
    lesson.surface.cells = 32;
    lesson.technique.reset(); // its seam is longer than the plate
    lesson.acceptance.reset();
    std::vector<TorchSample> samples(5);
    const std::array<double, 5> times{0, 0.1, 0.7, 2.5, kSeconds};
    const std::array<float, 5> places{-0.0045F, -0.0045F, -0.0045F, 0.0045F, 0.0045F};
    for (size_t i = 0; i < samples.size(); ++i) {
        samples[i].time = times[i];
        samples[i].tip = {places[i], 0.002F, 0};
        samples[i].orientation = heldOrientation(1.5707963, 0.1745, {1, 0, 0});
        samples[i].trigger = i == 0 || i >= 3 ? 0.0F : 1.0F;
    }
    lesson.torch = TorchPath(samples);
    return lesson;
}

struct Welded {
    Judgement judgement;
    std::uint64_t hash = 0;
};

Welded weld(const Lesson& lesson, const ChangedPath* path, std::vector<AttemptStep>* kept) {
    Trainer trainer(test::shaders(), lesson);
    const double seconds = path != nullptr ? path->duration() : kSeconds;
    const auto steps = static_cast<size_t>(seconds / trainer.timeStep() * (1 - 1e-6)) + 1;
    for (size_t step = 0; step < steps; ++step) {
        const auto burnt = static_cast<double>(trainer.metal().model().burntOff());
        const TorchSample torch =
            path != nullptr ? path->sample(trainer.time() + trainer.timeStep(), burnt) : trainer.demonstration();
        if (kept != nullptr) kept->push_back({torch, burnt, trainer.arc().burns()});
        trainer.advance(torch, nullptr);
    }
    Welded welded{trainer.judge(), trainer.result().stateHash};
    REQUIRE(welded.judgement.weld);
    REQUIRE(welded.judgement.weld->mean.penetration);
    REQUIRE(welded.judgement.weld->mean.fusedWidth);
    return welded;
}

/// Welds an attempt with this wish.
Welded weldIf(const Lesson& lesson, const std::vector<AttemptStep>& steps, const std::string& wish) {
    const WhatIf whatIf = readWhatIf(std::vector{wish}, lesson);
    Lesson other = lesson;
    takeWhatIf(other, whatIf, whatIf.path.speed);
    const ChangedPath path(steps, seamOf(lesson.workpiece), whatIf.path);
    return weld(other, &path, nullptr);
}

} // namespace

TEST_CASE("one thing changed changes the weld as physics has it", "[training][comparison]") {
    const Lesson lesson = smallTrack();
    std::vector<AttemptStep> steps;
    const Welded original = weld(lesson, nullptr, &steps);
    CHECK(weldIf(lesson, steps, "speed=1").hash == original.hash);

    const AttemptFigures before = figuresOf(original.judgement, lesson.process);
    const auto told = [&](const Welded& other) {
        return comparisonText(compareAttempts(before, figuresOf(other.judgement, lesson.process)));
    };
    const WeldStation& own = original.judgement.weld->mean;

    const Welded slower = weldIf(lesson, steps, "speed=0.5");
    WARN("half as fast: " << told(slower));
    CHECK(*slower.judgement.weld->mean.penetration > *own.penetration);
    CHECK(*slower.judgement.weld->mean.fusedWidth > *own.fusedWidth);
    CHECK(slower.judgement.arc.seconds > 1.9 * original.judgement.arc.seconds);

    const Welded hotter = weldIf(lesson, steps, "current=150");
    WARN("150 A for 110 A: " << told(hotter));
    CHECK(*hotter.judgement.weld->mean.fusedWidth > *own.fusedWidth);
    CHECK(*hotter.judgement.weld->mean.penetration > *own.penetration);
    CHECK(hotter.judgement.arc.meanCurrent() == Approx(150).epsilon(0.05));

    const Welded longer = weldIf(lesson, steps, "arc_length=3");
    WARN("an arc 3 mm longer: " << told(longer));
    CHECK(longer.judgement.arc.meanVoltage() > original.judgement.arc.meanVoltage() + 0.5);
    CHECK(longer.hash != original.hash);
}
