#include "app/bench/lesson.hpp"

#include "app/bench/parts.hpp"
#include "core/base/resources.hpp"
#include "core/render/camera.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer/lesson_scene.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <limits>

namespace meltpool {

namespace {

using Clock = std::chrono::steady_clock;

/// Wall time of the parts, ms.
struct Spent {
    double physics = 0, surface = 0, picture = 0;
};

/// Demonstration of the lesson, with a picture whenever one is due.
class WeldedDemonstration {
  public:
    WeldedDemonstration(Bench& bench, const Lesson& lesson, const LessonMeasurement& m)
        : trainer_(bench.shaders(), lesson),
          scene_(bench.shaders(), trainer_),
          renderer_(bench.shaders()),
          target_(m.width, m.height),
          view_(OrbitCamera().view(Lens{}, static_cast<float>(m.width) / static_cast<float>(m.height))),
          perSecond_(m.picturesPerSecond) {}

    /// Makes steps, and pictures when due, until `time` s.
    void runUntil(double time) {
        while (trainer_.time() + 0.5 * trainer_.timeStep() < time) {
            timed(spent.physics, [&] { trainer_.advance(trainer_.demonstration(), nullptr); });
            if (trainer_.time() * perSecond_ < static_cast<double>(pictures_ + 1)) continue;
            ++pictures_;
            timed(spent.surface, [&] { scene_.updateSurface(nullptr); });
            timed(spent.picture, [&] {
                renderer_.draw(scene_.view(), trainer_.lesson().look, {&view_, 1}, target_.target(), nullptr);
            });
        }
    }

    const Trainer& trainer() const { return trainer_; }
    size_t surfaceBytes() const { return scene_.surface().bytes(); }
    size_t pictures() const { return pictures_; }

    Spent spent;

  private:
    template <typename Work>
    static void timed(double& sum, const Work& work) {
        const auto start = Clock::now();
        work();
        glFinish();
        sum += millisecondsSince(start);
    }

    Trainer trainer_;
    LessonScene scene_;
    Renderer renderer_;
    PictureTarget target_;
    View view_;
    int perSecond_;
    size_t pictures_ = 0;
};

} // namespace

BenchRow measureLesson(Bench& bench, const Lesson& lesson, const LessonMeasurement& measurement) {
    WeldedDemonstration run(bench, lesson, measurement);
    run.runUntil(measurement.warmUp);
    run.spent = {};
    const size_t steps = run.trainer().steps(), pictures = run.pictures();
    const std::uint64_t dispatches = gl::dispatchCount();
    const std::clock_t processor = std::clock();
    double wall = 0, least = std::numeric_limits<double>::infinity();
    for (int second = 1; second <= measurement.seconds; ++second) {
        const auto start = Clock::now();
        run.runUntil(measurement.warmUp + second);
        const double spent = millisecondsSince(start);
        wall += spent;
        least = std::min(least, spent);
    }
    const double seconds = measurement.seconds;
    const Spent& spent = run.spent;
    const LessonResult result = run.trainer().result();
    BenchRow row;
    row.suite = "lesson";
    row.what = lesson.key + ", simulated second";
    row.particles = result.metal.particles;
    row.bytes = result.metalBytes + run.surfaceBytes();
    row.bytesPerParticle = static_cast<double>(result.metalBytes) / static_cast<double>(row.particles);
    row.stepMs = least;
    row.further = {{"simulated_over_wall", seconds * 1e3 / wall},
                   {"simulated_over_wall_best", 1e3 / least},
                   {"physics_share", spent.physics / wall},
                   {"surface_share", spent.surface / wall},
                   {"picture_share", spent.picture / wall},
                   {"rest_share", 1 - (spent.physics + spent.surface + spent.picture) / wall},
                   {"cpu_ms", static_cast<double>(std::clock() - processor) * 1e3 / CLOCKS_PER_SEC / seconds},
                   {"steps", static_cast<double>(run.trainer().steps() - steps) / seconds},
                   {"pictures", static_cast<double>(run.pictures() - pictures) / seconds},
                   {"dispatches", static_cast<double>(gl::dispatchCount() - dispatches) / seconds}};
    return row;
}

/// Measures at low detail, with which a window starts if the driver draws in software; `bench looks` has the others.
void benchLesson(Bench& bench) {
    Lesson lesson = findLesson("gmaw-bead", resourceFolder() / "data" / "lessons");
    lesson.look.detail = kLowDetail;
    bench.add(measureLesson(bench, lesson, {}));
}

} // namespace meltpool
