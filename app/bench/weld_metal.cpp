// The cost of a frame of welding: a GMAW bead on a 6 mm plate with a steady pool, on a plate of four times the area
// too.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "core/base/resources.hpp"
#include "core/surface/surface.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/trainer/weld_model.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <numeric>

namespace meltpool {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kWarmUpSeconds = 3; ///< simulated s of welding: by then the pool is about as long as it gets
constexpr int kMeasuredFrames = 52;  ///< two cycles of finding the fragments
constexpr int kProfiledFrames = 52;  ///< two cycles, too

/// Wall and processor time of each frame, ms. The processor time is that of all this program's threads: with a software
/// driver the figure that other programs on the machine disturb least.
struct FrameTimes {
    std::vector<double> wall, processor;

    void measure(const std::function<void()>& work) {
        const auto start = Clock::now();
        const std::clock_t spent = std::clock();
        work();
        glFinish();
        processor.push_back(static_cast<double>(std::clock() - spent) * 1e3 / CLOCKS_PER_SEC);
        wall.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
};

/// Dispatches of each step.
class DispatchCount {
  public:
    void measure(const std::function<void()>& work) {
        const std::uint64_t before = gl::dispatchCount();
        work();
        sum_ += static_cast<double>(gl::dispatchCount() - before);
        ++steps_;
    }
    double mean() const { return sum_ / steps_; }

  private:
    double sum_ = 0;
    int steps_ = 0;
};

double least(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Median of the quotients of two lists, entry by entry.
double medianRatio(const std::vector<double>& above, const std::vector<double>& below) {
    std::vector<double> ratios;
    for (size_t i = 0; i < above.size(); ++i)
        ratios.push_back(above[i] / below[i]);
    return median(ratios);
}

/// Bead of the lesson on its plate, or on one `edge` times as long and wide. The torch's path does not change.
class BenchWeld {
  public:
    BenchWeld(gl::ShaderLibrary& shaders, int edge) : lesson_(lessonOf(edge)), model_(shaders, lesson_) {
        const SceneView scene = model_.makeScene()->view({});
        surface_ = std::make_unique<Surface>(shaders, lesson_.surface, scene.boxMin, scene.boxMax);
        model_.prepare(*surface_);
    }

    void step(gl::Profiler* profiler) {
        ++frame_;
        model_.step(lesson_.torch.sample(frame_ * model_.timeStep()), profiler);
    }

    void updateFigures() {
        if (!asked_ || model_.pollStatistics()) model_.requestStatistics();
        asked_ = true;
    }

    void updateSurface(gl::Profiler* profiler) { surface_->update(model_.particles(), profiler); }

    double timeStep() const { return model_.timeStep(); }
    int steps() const { return frame_; }
    const WeldModel& model() const { return model_; }

    BenchRow row(BenchRow row) const {
        row.particles = model_.particles().count;
        row.bytes = model_.bytes();
        row.bytesPerParticle = static_cast<double>(row.bytes) / static_cast<double>(row.particles);
        return row;
    }

    size_t surfaceBytes() const { return surface_->bytes(); }

  private:
    static Lesson lessonOf(int edge) {
        Lesson lesson = findLesson("gmaw-bead", resourceFolder() / "data" / "lessons");
        const auto grow = [&](float size) { return std::to_string(size * static_cast<float>(edge)); };
        lesson.set("length_mm", grow(lesson.workpiece.lengthMm), "bench");
        lesson.set("width_mm", grow(lesson.workpiece.widthMm), "bench");
        lesson.surface.cells *= edge; // cells of equal size
        return lesson;
    }

    Lesson lesson_;
    WeldModel model_;
    std::unique_ptr<Surface> surface_;
    int frame_ = 0;
    bool asked_ = false;
};

/// Times of the passes, in a run of their own: measuring them costs time itself.
BenchRow passes(Bench& bench, std::string what, BenchWeld& weld) {
    return bench.measure(
        std::move(what),
        [&](gl::Profiler& profiler) {
            weld.step(&profiler);
            weld.updateFigures();
            weld.updateSurface(&profiler);
        },
        60.0, kProfiledFrames, kProfiledFrames);
}

/// Row of a weld's metal, without the surface.
BenchRow physicsRow(BenchRow row, const BenchWeld& weld, const FrameTimes& physics, const DispatchCount& dispatches) {
    const double frame = weld.timeStep() * 1e3;
    const PhysicalMetal& metal = weld.model().metal();
    row = weld.row(std::move(row));
    row.stepMs = least(physics.wall);
    row.further = {{"simulated_ms", frame},
                   {"median_ms", median(physics.wall)},
                   {"cpu_ms", mean(physics.processor)},
                   {"least_cpu_ms", least(physics.processor)},
                   {"simulated_over_wall", frame / mean(physics.wall)},
                   {"simulated_over_wall_least", frame / least(physics.wall)},
                   {"simulated_over_cpu_of_two_cores", 2 * frame / mean(physics.processor)},
                   {"dispatches", dispatches.mean()},
                   {"moving_particles", metal.flow().readMoving()},
                   {"searches", metal.flow().readSearches() / static_cast<double>(weld.steps())},
                   {"active_tiles", metal.heat().readActiveTiles()},
                   {"tiles", static_cast<double>(metal.state().lattice().tileCount())},
                   {"faults", metal.flow().readFaults().any() ? 1.0 : 0.0}};
    return row;
}

/// Adds the rows of the work after each step in the trainer, for both plates.
void addPair(Bench& bench, const std::string& what, const BenchWeld& plate, const FrameTimes& times,
             const BenchWeld& large, const FrameTimes& timesLarge) {
    for (const bool isLarge : {false, true}) {
        const FrameTimes& own = isLarge ? timesLarge : times;
        BenchRow row;
        row.suite = "weld";
        row.what = what + (isLarge ? ", area x4" : "");
        row.particles = (isLarge ? large : plate).model().particles().count;
        row.bytes = (isLarge ? large : plate).surfaceBytes();
        row.stepMs = least(own.wall);
        row.further = {{"median_ms", median(own.wall)}, {"cpu_ms", mean(own.processor)}};
        if (isLarge) {
            row.further.emplace_back("over_plate", least(timesLarge.wall) / least(times.wall));
            row.further.emplace_back("over_plate_cpu", mean(timesLarge.processor) / mean(times.processor));
        }
        bench.add(std::move(row));
    }
}

} // namespace

void benchWeldMetal(Bench& bench) {
    BenchWeld plate(bench.shaders(), 1), large(bench.shaders(), 2);
    for (int i = 0; i < static_cast<int>(kWarmUpSeconds / plate.timeStep()); ++i)
        for (BenchWeld* weld : {&plate, &large}) {
            weld->step(nullptr);
            weld->updateFigures();
            weld->updateSurface(nullptr);
        }
    // In turns, so that other load on the machine disturbs both alike.
    FrameTimes physics, physicsLarge, figures, figuresLarge, surface, surfaceLarge;
    DispatchCount dispatches, dispatchesLarge;
    for (int i = 0; i < kMeasuredFrames; ++i) {
        physics.measure([&] { dispatches.measure([&] { plate.step(nullptr); }); });
        physicsLarge.measure([&] { dispatchesLarge.measure([&] { large.step(nullptr); }); });
        figures.measure([&] { plate.updateFigures(); });
        figuresLarge.measure([&] { large.updateFigures(); });
        surface.measure([&] { plate.updateSurface(nullptr); });
        surfaceLarge.measure([&] { large.updateSurface(nullptr); });
    }
    bench.add(physicsRow(passes(bench, "GMAW bead, frame", plate), plate, physics, dispatches));
    BenchRow row = physicsRow(passes(bench, "GMAW bead, area x4", large), large, physicsLarge, dispatchesLarge);
    row.further.emplace_back("over_plate", least(physicsLarge.wall) / least(physics.wall));
    row.further.emplace_back("over_plate_median", medianRatio(physicsLarge.wall, physics.wall));
    row.further.emplace_back("over_plate_cpu", mean(physicsLarge.processor) / mean(physics.processor));
    bench.add(std::move(row));
    addPair(bench, "figures", plate, figures, large, figuresLarge);
    addPair(bench, "surface under the bead", plate, surface, large, surfaceLarge);
}

} // namespace meltpool
