// The cost of a desktop frame of the classic lesson: one step, the surface, one picture.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "core/base/resources.hpp"
#include "core/render/camera.hpp"
#include "core/render/picture_target.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer/lesson_scene.hpp"

namespace meltpool {

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr int kMeltingSteps = 90; ///< before measuring: the corner is liquid and flows

} // namespace

void benchClassicFrame(Bench& bench) {
    Lesson lesson = findLesson(std::string(kDefaultLesson), resourceFolder() / "data" / "lessons");
    lesson.set("particles", "8192", "bench");
    lesson.set("cells", "64", "bench");
    Trainer trainer(bench.shaders(), lesson);
    LessonScene shown(bench.shaders(), trainer);
    Renderer renderer(bench.shaders());
    const PictureTarget target(kWidth, kHeight);
    const View view = OrbitCamera().view(Lens{}, static_cast<float>(kWidth) / kHeight);
    for (int i = 0; i < kMeltingSteps; ++i)
        trainer.advance(trainer.demonstration(), nullptr);
    BenchRow row = bench.measure(
        "frame",
        [&](gl::Profiler& profiler) {
            trainer.advance(trainer.demonstration(), &profiler);
            shown.updateSurface(&profiler);
            renderer.draw(shown.view(), trainer.lesson().look, {&view, 1}, target.target(), &profiler);
        },
        3.0);
    const LessonResult result = trainer.result();
    row.particles = result.metal.particles;
    row.bytes = result.metalBytes + shown.surface().bytes();
    row.bytesPerParticle = static_cast<double>(result.metalBytes) / static_cast<double>(row.particles);
    row.further = {{"frames_per_second", 1e3 / row.stepMs},
                   {"grid", static_cast<double>(trainer.lesson().surface.cells)}};
    bench.add(std::move(row));
}

} // namespace meltpool
