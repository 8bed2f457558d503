#include "app/bench/looks.hpp"

#include "app/bench/parts.hpp"
#include "core/base/resources.hpp"
#include "core/render/camera.hpp"
#include "core/render/look/measures.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer/lesson_scene.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>
#include <optional>

namespace meltpool {

namespace {

constexpr float kBetweenEyes = 0.063f; // m of a head; the lesson's world is not scaled for it

/// Look and its measured row.
struct MeasuredLook {
    std::string what;
    LookParameters look;
    size_t eyes = 1;
    std::optional<DetailFeature> without = {};
    BenchRow row = {};
};

std::vector<MeasuredLook> looksToMeasure(const LookParameters& lesson) {
    constexpr std::array<const char*, 3> kLevels{"low", "medium", "high"};
    constexpr std::array<const char*, 2> kEyes{", one eye", ", two eyes"};
    std::vector<MeasuredLook> all;
    for (size_t eyes = 1; eyes <= kEyes.size(); ++eyes) {
        LookParameters look = lesson;
        for (const int level : {kHighDetail, kMediumDetail, kLowDetail}) {
            look.detail = level;
            all.push_back({std::string(kLevels[static_cast<size_t>(level)]) + kEyes[eyes - 1], look, eyes});
        }
        look.detail = kHighDetail;
        for (const MeasureRow& each : kMeasures) {
            look.leftOut = bitOf(each.measure);
            all.push_back(
                {"high without " + std::string(each.key) + kEyes[eyes - 1], look, eyes, std::optional(each.measure)});
        }
    }
    return all;
}

double gpuMs(const BenchRow& row) {
    const auto draw =
        std::find_if(row.passes.begin(), row.passes.end(), [](const auto& pass) { return pass.name == "draw"; });
    return draw == row.passes.end() ? 0 : draw->leastMs;
}

/// Adds the numbers per eye, from those of the picture. `high`: the row of all measures with as many eyes.
void tellOfAnEye(MeasuredLook& measured, const BenchRow& high) {
    const auto eyes = static_cast<double>(measured.eyes);
    const double cpu = measured.row.further.front().second, highCpu = high.further.front().second;
    measured.row.further = {{"cpu_ms", cpu / eyes}, {"gpu_ms", gpuMs(measured.row) / eyes}};
    auto& further = measured.row.further;
    if (!measured.without) {
        further.emplace_back("cpu_over_high", cpu / highCpu);
        return;
    }
    further.emplace_back("measure_cpu_ms", (highCpu - cpu) / eyes);
    further.emplace_back("measure_gpu_ms", (gpuMs(high) - gpuMs(measured.row)) / eyes);
}

} // namespace

void measureLooks(Bench& bench, const Lesson& lesson, const LooksMeasurement& m) {
    Trainer trainer(bench.shaders(), lesson);
    LessonScene shown(bench.shaders(), trainer);
    while (trainer.time() + 0.5 * trainer.timeStep() < m.moment)
        trainer.advance(trainer.demonstration(), nullptr);
    shown.updateSurface(nullptr);
    const SceneView scene = shown.view();
    Renderer renderer(bench.shaders());
    const PictureTarget one(m.width, m.height), two(2 * m.width, m.height);
    const View middle = OrbitCamera().view(Lens{}, static_cast<float>(m.width) / static_cast<float>(m.height));
    std::array<View, 2> views{middle, middle};
    for (size_t i = 0; i < views.size(); ++i) {
        const float side = (i == 0 ? 0.5f : -0.5f) * kBetweenEyes;
        views[i].worldToEye[3].x += side;
        views[i].eye -= glm::vec3(middle.worldToEye[0].x, middle.worldToEye[1].x, middle.worldToEye[2].x) * side;
    }
    const auto draw = [&](const MeasuredLook& measured) {
        const std::span<const View> eyes = measured.eyes == 1 ? std::span(&middle, 1) : std::span<const View>(views);
        const RenderTarget target = (measured.eyes == 1 ? one : two).target();
        double cpuMs = std::numeric_limits<double>::infinity();
        BenchRow row = bench.measure(
            measured.what,
            [&](gl::Profiler& profiler) {
                const std::clock_t start = std::clock();
                renderer.draw(scene, measured.look, eyes, target, &profiler);
                glFinish();
                cpuMs = std::min(cpuMs, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
            },
            m.seconds, 2);
        row.further = {{"cpu_ms", cpuMs}};
        return row;
    };
    std::vector<MeasuredLook> all = looksToMeasure(trainer.lesson().look);
    for (int round = 0; round < m.rounds; ++round)
        for (MeasuredLook& each : all)
            keepLeast(each.row, draw(each));
    std::array<BenchRow, 2> high;
    for (const MeasuredLook& each : all)
        if (!each.without && each.look.detail == kHighDetail) high[each.eyes - 1] = each.row;
    for (MeasuredLook& each : all) {
        tellOfAnEye(each, high[each.eyes - 1]);
        bench.add(std::move(each.row));
    }
}

void benchLooks(Bench& bench) {
    measureLooks(bench, findLesson("gmaw-bead", resourceFolder() / "data" / "lessons"), {});
}

} // namespace meltpool
