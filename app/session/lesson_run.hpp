// The running metal of a lesson: its Trainer, its scene, the clock that its steps follow, and the fault that stopped
// it.
#pragma once

#include "app/activities/activities.hpp"
#include "core/base/function_ref.hpp"
#include "core/training/trainer/lesson_scene.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// Input of a frame for the metal's steps.
struct RunFrame {
    double seconds = 0;    ///< s of real time since the last frame
    bool waits = false;    ///< see ActivityFrame
    bool forScore = false; ///< see ActivityFrame
    TorchSource torch;     ///< torch of the person
};

class LessonRun {
  public:
    /// Runs the metal of `activities`. `now`: clock that measures the steps. `metalThread`: context of the metal, see
    /// LessonMetal. All must outlive this.
    LessonRun(gl::ShaderLibrary& shaders, Activities& activities, Stopwatch now, gl::ContextThread* metalThread);

    /// Frees the old metal and its clock and makes that of this lesson. Throws InputError or RuntimeFault when memory
    /// or driver do not suffice; then there is none.
    void make(Lesson lesson);
    /// Frees the metal and ends the activity.
    void free();
    /// Begins an activity over the metal's start state: clears the fault.
    void beginAgain();

    /// Metal and process; null without metal.
    Trainer* trainer() { return trainer_.get(); }
    const Trainer* trainer() const { return trainer_.get(); }
    /// Scene of the metal; null without metal.
    LessonScene* scene() { return scene_.get(); }
    /// Arc of the last step; out without metal.
    ArcState arc() const { return trainer_ ? trainer_->arc() : ArcState{}; }
    /// Torch of the last step. Requires metal.
    const TorchSample& torch() const { return trainer_->torch(); }
    /// See Process::burntOff(), m; 0 without metal.
    float burntOff() const { return trainer_ ? trainer_->metal().model().burntOff() : 0; }
    /// Place at which the torch of the last step works, in the workpiece's frame, m: its tip, or the end to which its
    /// electrode has burned. Requires metal.
    glm::vec3 torchEnd() const { return torch().tip - torch().axis() * burntOff(); }
    size_t steps() const { return trainer_ ? trainer_->steps() : 0; }
    /// Notes in the attempt's record an event after the last step: `recentred`, `torch_lost`, `zoom 2`. No-op outside
    /// an attempt.
    void event(std::string_view name, std::string_view value = {});
    /// Reason why the attempt's record was cut short; empty while it is whole or none is wanted.
    const std::string& recordFault() const;

    /// Cost of the metal's steps per frame.
    StepClock& clock() { return clock_; }
    const StepClock& clock() const { return clock_; }
    Stopwatch stopwatch() const { return now_; }

    /// Fault that stopped the simulation; empty while it runs.
    const std::string& fault() const { return fault_; }
    void stop(std::string fault) { fault_ = std::move(fault); }
    /// Runs `work` and stops the simulation if it throws: a fault of the machine, or a damaged recording.
    void guarded(FunctionRef<void()> work);

    /// Runs the next steps in parallel with a picture, whose frame takes `rest` seconds without the steps; 0: before
    /// the picture.
    void stepBeside(double rest) { beside_ = rest; }
    /// Returns true if makeSteps() and then finishSteps() must be called before anything else of the lesson except
    /// completing and drawing its picture. `soundSteps` hears the steps. Outside a lesson there are no steps: false.
    bool beginSteps(RunFrame frame, SoundSteps& soundSteps, gl::Profiler* profiler);
    /// Makes the steps; may run on the thread of the metal's context, while the picture shows the metal as it was.
    void makeSteps(gl::Profiler* profiler);
    void finishSteps();
    /// Metal's time of the frame's steps, s. Requires metal, after beginSteps().
    double secondsDue() const { return due_ * trainer_->timeStep(); }

    /// Marks the metal as changed since the last noteMetal().
    void metalChanged() { changed_ = true; }
    /// See LessonScene::noteMetal(); no-op while the metal has not changed.
    void noteMetal();

    /// Requests the distance from the torch in the hand to the metal. The answer arrives frames later; nothing waits
    /// for it.
    void requestSurfaceDistance(const TorchSample& torch);
    /// Newest answer; before the first one, no metal anywhere.
    const SurfaceDistance& surfaceDistance() const { return surfaceDistance_; }
    void forgetSurfaceDistance() { surfaceDistance_ = {}; }

  private:
    gl::ShaderLibrary& shaders_;
    Activities& activities_;
    gl::ContextThread* metalThread_;
    Stopwatch now_;
    std::unique_ptr<Trainer> trainer_;
    std::unique_ptr<LessonScene> scene_; ///< scene of the trainer
    StepClock clock_;
    double beside_ = 0;                  ///< see stepBeside()
    std::optional<ActivityFrame> frame_; ///< set between beginSteps() and finishSteps()
    int due_ = 0;                        ///< steps of that frame
    std::string fault_;
    bool changed_ = true;
    SurfaceDistance surfaceDistance_;
};

} // namespace meltpool
