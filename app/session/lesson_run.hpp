// The running metal of a lesson: its Trainer, how it is seen, the clock that its steps follow, and the fault that
// stopped it.
#pragma once

#include "app/activities/activities.hpp"
#include "core/base/function_ref.hpp"
#include "core/training/trainer/lesson_scene.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// A frame of the person at whom the metal's steps are led.
struct RunFrame {
    double seconds = 0;    ///< of real time since the last frame
    bool waits = false;    ///< see ActivityFrame
    bool forScore = false; ///< likewise
    TorchSource torch;     ///< of the person
};

class LessonRun {
  public:
    /// Runs what `activities` are at. `now` tells how long steps take. `metalThere`: the metal lies in that
    /// context, see LessonMetal. All must outlive this.
    LessonRun(gl::ShaderLibrary& shaders, Activities& activities, Stopwatch now, gl::OtherContext* metalThere);

    /// Makes the metal of this lesson in the place of the one before, which is freed first, and with it the clock.
    /// Throws InputError or RuntimeFault when memory or driver do not suffice; then there is none.
    void make(Lesson lesson);
    /// There is no metal any more, and no activity.
    void free();
    /// An activity begins over the metal at its start: no fault has stopped it yet.
    void beginAgain();

    /// Metal and process; null where there are none.
    Trainer* trainer() { return trainer_.get(); }
    const Trainer* trainer() const { return trainer_.get(); }
    /// How the metal is seen; null where there is none.
    LessonScene* scene() { return scene_.get(); }
    /// The arc of the last step; out where there is no metal.
    ArcState arc() const { return trainer_ ? trainer_->arc() : ArcState{}; }
    /// The torch of the last step. Only where there is metal.
    const TorchSample& torch() const { return trainer_->torch(); }
    size_t steps() const { return trainer_ ? trainer_->steps() : 0; }
    /// Notes in the attempt's record what happened after the last step: `recentred`, `torch_lost`, `zoom 2`. No-op
    /// outside an attempt.
    void event(std::string_view name, std::string_view value = {});
    /// Why the attempt's record was cut short; empty while it is whole or none is wanted.
    const std::string& recordFault() const;

    /// Costs of the metal's steps in the frames.
    StepClock& clock() { return clock_; }
    const StepClock& clock() const { return clock_; }
    Stopwatch stopwatch() const { return now_; }

    /// The fault that stopped the simulation; empty while it runs.
    const std::string& fault() const { return fault_; }
    void stop(std::string fault) { fault_ = std::move(fault); }
    /// Runs what may find a fault of the machine, or a recording that is damaged: then the simulation stops.
    void guarded(FunctionRef<void()> work);

    /// The next steps are made beside a picture, whose frame takes so long besides steps (s); 0: before it.
    void stepBeside(double rest) { beside_ = rest; }
    /// True: makeSteps() and then finishSteps() are to be called before anything else of the lesson but completing and
    /// drawing its picture. `ear` hears them. Outside a lesson nothing is left to be made: false.
    bool beginSteps(RunFrame frame, Ear& ear, gl::Profiler* profiler);
    /// May run on the thread of the metal's context, while the picture shows the metal as it was.
    void makeSteps(gl::Profiler* profiler);
    void finishSteps();

    /// The metal is another than at the last noteMetal().
    void metalChanged() { changed_ = true; }
    /// See LessonScene::noteMetal(); no-op while the metal has not changed.
    void noteMetal();

    /// Asks where the metal lies under the torch in the hand. The answer comes frames later; nothing waits for it.
    void requestSurfaceDistance(const TorchSample& torch);
    /// The newest answer; no metal anywhere before the first.
    const SurfaceDistance& surfaceDistance() const { return surfaceDistance_; }
    void forgetSurfaceDistance() { surfaceDistance_ = {}; }

  private:
    gl::ShaderLibrary& shaders_;
    Activities& activities_;
    gl::OtherContext* metalThere_;
    Stopwatch now_;
    std::unique_ptr<Trainer> trainer_;
    std::unique_ptr<LessonScene> scene_; ///< of the trainer
    StepClock clock_;
    double beside_ = 0;                  ///< see stepBeside()
    std::optional<ActivityFrame> frame_; ///< between beginSteps() and finishSteps()
    int due_ = 0;                        ///< steps of it
    std::string fault_;
    bool changed_ = true;
    SurfaceDistance surfaceDistance_;
};

} // namespace meltpool
