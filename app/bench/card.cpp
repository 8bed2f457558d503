#include "app/bench/card.hpp"

#include "app/bench/parts.hpp"
#include "core/base/resources.hpp"
#include "core/metal/flow/flow.hpp"
#include "core/render/camera.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer/lesson_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

namespace meltpool {

namespace {

using Clock = std::chrono::steady_clock;

constexpr float kSpacing = 1e-3f;  // m
constexpr float kLiquid = 1900;    // K, of steel
constexpr int kLeastRepeats = 5;   // count of timed repeats
constexpr int kSmallestPool = 256; // particles
constexpr int kPoolGrowth = 4;
constexpr unsigned kSubsteps = 8;    // count in a step
constexpr int kSamples = 4;          // samples of a pixel, as in the headset
constexpr float kEyeDistance = 1.6f; // units of the lesson's world: each eye over its half of the bead
constexpr double kOften = 0.99;      // share of frames that a headset must have in time

double millisecondsOfProcessor(std::clock_t since) {
    return static_cast<double>(std::clock() - since) * 1e3 / CLOCKS_PER_SEC;
}

/// Wall times (ms) of work that is waited for, until `seconds` have passed.
struct Times {
    std::vector<double> wall;
    double processor = 0; ///< ms of all threads, mean

    /// Times `work`. `between` runs before each repeat, untimed.
    template <typename Work, typename Between>
    Times(double seconds, int repeats, const Work& work, const Between& between) {
        const auto begin = Clock::now();
        const auto more = [&] {
            const auto count = static_cast<int>(wall.size());
            return count < kLeastRepeats || (count < repeats && millisecondsSince(begin) < seconds * 1e3);
        };
        while (more()) {
            between();
            glFinish();
            const auto start = Clock::now();
            const std::clock_t spent = std::clock();
            work();
            glFinish();
            wall.push_back(millisecondsSince(start));
            processor += millisecondsOfProcessor(spent);
        }
        processor /= static_cast<double>(wall.size());
        std::sort(wall.begin(), wall.end());
    }

    template <typename Work>
    Times(double seconds, int repeats, const Work& work) : Times(seconds, repeats, work, [] {}) {}

    double at(double share) const {
        return wall[static_cast<size_t>(share * static_cast<double>(wall.size() - 1) + 0.5)];
    }

    BenchRow row(std::string what, size_t particles) const {
        BenchRow row;
        row.suite = "card";
        row.what = std::move(what);
        row.particles = particles;
        row.stepMs = wall.front();
        row.further = {{"median_ms", at(0.5)},
                       {"ms_99", at(kOften)},
                       {"cpu_ms", processor},
                       {"repeats", static_cast<double>(wall.size())}};
        return row;
    }
};

/// Cube of free liquid without forces: each particle has all its neighbours, as deep in a pool.
std::vector<MetalSeed> pool(int edge) {
    std::vector<MetalSeed> seeds;
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x)
                seeds.push_back(
                    {(glm::vec3(x, y, z) + 0.5f) * kSpacing, kLiquid, PHASE_ALIVE | PHASE_LIQUID, glm::vec3(0)});
    return seeds;
}

/// Row of one pool.
BenchRow poolRow(Bench& bench, const Material& metal, int edge, const CardLimits& limits) {
    const std::vector<MetalSeed> seeds = pool(edge);
    const float size = static_cast<float>(edge) * kSpacing, air = 4 * kSpacing;
    const FlowSpace space{glm::vec3(-air), glm::vec3(size + air), glm::bvec3(false), glm::vec3(0)};
    FlowFluid fluid;
    fluid.density = metal.solidDensity.at(metal.solidus);
    fluid.tension = metal.tensionAt(metal.liquidus);
    fluid.viscosity = metal.viscosity.at(metal.liquidus);
    MetalState state(MetalLattice::covering(space.low, space.low, kSpacing), HeatTable(metal), fluid.density,
                     seeds.size());
    state.setGravity(glm::vec3(0));
    state.add(seeds);
    Flow flow(bench.shaders(), state, fluid, space);
    const double substep = flow.constants().longestStep;
    const auto step = [&] { flow.step(kSubsteps * substep, kSubsteps, nullptr); };
    step(); // allocates
    // A quarter of the row's time: there are up to six.
    const Times times(limits.seconds / 4, limits.repeats, step);
    BenchRow row = times.row("eight substeps of a pool", seeds.size());
    row.bytes = state.bytes() + flow.bytes();
    row.bytesPerParticle = static_cast<double>(row.bytes) / static_cast<double>(seeds.size());
    row.further.emplace_back("ns_per_particle_and_substep",
                             times.at(0.5) * 1e6 / kSubsteps / static_cast<double>(seeds.size()));
    row.further.emplace_back("searches", flow.readSearches());
    row.further.emplace_back("faults", flow.readFaults().any() ? 1.0 : 0.0);
    return row;
}

/// Both eyes over the bead, side by side.
std::array<View, 2> eyesOver(float aspect) {
    constexpr float kBetween = 0.063f; // m of a head; the lesson's world is not scaled for it
    std::array<View, 2> eyes;
    for (size_t i = 0; i < eyes.size(); ++i) {
        const float side = (i == 0 ? -0.5f : 0.5f) * kBetween;
        eyes[i] = makeView({side, kEyeDistance, 0.5f}, glm::angleAxis(-1.2f, glm::vec3(1, 0, 0)), Lens{}, aspect);
    }
    return eyes;
}

} // namespace

void measurePools(Bench& bench, const CardLimits& limits) {
    const Material metal = workpieceMaterial(Lesson{}.workpiece);
    for (int wanted = kSmallestPool; wanted <= limits.largestPool; wanted *= kPoolGrowth) {
        const int edge = static_cast<int>(std::lround(std::cbrt(wanted)));
        BenchRow row = poolRow(bench, metal, edge, limits);
        const bool slow = row.stepMs > limits.longestPool * 1e3;
        bench.add(std::move(row));
        if (slow) break;
    }
}

void measureWeldAndEyes(Bench& bench, const Lesson& lesson, const CardLimits& limits) {
    Trainer trainer(bench.shaders(), lesson);
    LessonScene shown(bench.shaders(), trainer);
    const auto begin = Clock::now();
    const auto step = [&] { trainer.advance(trainer.demonstration(), nullptr); };
    while (trainer.time() < limits.weldSeconds && millisecondsSince(begin) < limits.seconds * 1e3) {
        step();
        glFinish();
    }
    const double warm = trainer.time();
    const std::uint64_t dispatches = gl::dispatchCount();
    const size_t steps = trainer.steps();
    const Times times(limits.seconds / 2, limits.repeats, step);
    const LessonResult result = trainer.result();
    BenchRow weld = times.row(lesson.key + ", step", result.metal.particles);
    weld.bytes = result.metalBytes;
    weld.bytesPerParticle = static_cast<double>(weld.bytes) / static_cast<double>(weld.particles);
    weld.further.insert(weld.further.end(), {{"simulated_ms", trainer.timeStep() * 1e3},
                                             {"simulated_over_wall", trainer.timeStep() * 1e3 / times.at(0.5)},
                                             {"welded_s", warm},
                                             {"molten", static_cast<double>(result.metal.molten)},
                                             {"dispatches", static_cast<double>(gl::dispatchCount() - dispatches) /
                                                                static_cast<double>(trainer.steps() - steps)}});
    bench.add(std::move(weld));
    const Times surface(
        limits.seconds / 4, limits.repeats, [&] { shown.updateSurface(nullptr); }, step);
    bench.add(surface.row(lesson.key + ", surface after a step", result.metal.particles));
    Renderer renderer(bench.shaders());
    const PictureTarget target(2 * limits.eyeWidth, limits.eyeHeight, kSamples);
    const auto eyes = eyesOver(static_cast<float>(limits.eyeWidth) / static_cast<float>(limits.eyeHeight));
    const SceneView scene = shown.view();
    BenchRow picture = Times(limits.seconds / 2, limits.repeats, [&] {
                           renderer.draw(scene, trainer.lesson().look, eyes, target.target(), nullptr);
                           target.resolve();
                       }).row(lesson.key + ", both eyes", result.metal.particles);
    picture.further.emplace_back("eye_width", limits.eyeWidth);
    picture.further.emplace_back("eye_height", limits.eyeHeight);
    bench.add(std::move(picture));
}

void benchCard(Bench& bench) {
    BenchRow empty = measureEmptyDispatches(bench);
    empty.suite = "card";
    bench.add(std::move(empty));
    const CardLimits limits;
    measurePools(bench, limits);
    Lesson lesson = findLesson("gmaw-bead", resourceFolder() / "data" / "lessons");
    measureWeldAndEyes(bench, lesson, limits);
    lesson.set("spacing_mm", "0.5", "bench");
    lesson.surface.cells *= 2; // cells for as many particles
    lesson.key += " at 0.5 mm";
    measureWeldAndEyes(bench, lesson, limits);
}

} // namespace meltpool
