// The part of LessonSession that makes the metal's steps, led by a hand, a demonstration or a kept attempt.
#include "app/session/lesson_session.hpp"
#include "core/training/trainer/classic_model.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <stdexcept>
#include <utility>

namespace meltpool {

namespace {

/// `turn`: from the workpiece's frame to the room's, in which the source is steered.
TorchSample torchOf(const SteeredSource& source, const glm::mat3& turn) {
    const glm::mat3 toWorkpiece = glm::transpose(turn);
    TorchSample sample;
    sample.tip = toWorkpiece * (source.position() * kClassicUnit);
    const glm::quat down = glm::angleAxis(-glm::half_pi<float>(), glm::vec3(1, 0, 0));
    sample.orientation = glm::quat_cast(toWorkpiece) * down;
    sample.trigger = source.on() ? 1.0f : 0.0f;
    return sample;
}

} // namespace

/// No steps are made in view mode, while the weld is cut open, after a fault and before a question is answered.
bool LessonSession::waits(const Controls& controls) {
    const bool pause = (controls.mode() == Mode::view && !held_) || cut_.shown();
    if (pause != paused_) event(pause ? "paused" : "resumed");
    paused_ = pause;
    return pause || !fault_.empty() || question_.asked();
}

void LessonSession::advance(const Controls& controls, double seconds, gl::Profiler* profiler, const TorchSource& held) {
    if (!beginSteps(controls, seconds, profiler, held)) return;
    makeSteps(profiler);
    finishSteps();
}

bool LessonSession::beginSteps(const Controls& controls, double seconds, gl::Profiler* profiler,
                               const TorchSource& held) {
    if (!running()) return false;
    sinceSeen_ += seconds;
    if (trial_.running()) {
        measureSpeed(seconds, profiler);
        return false;
    }
    surfaceIsOld_ |= takeOverChanges(controls);
    held_ = static_cast<bool>(held) && !played();
    if (replay_.shown()) return beginReplay(seconds, profiler);
    if (demonstration_.shown()) return beginDemonstration(seconds);
    if (cut_.shown()) inspect(controls);
    if (waits(controls)) {
        clock_.restart();
        return false;
    }
    if (!held_)
        desk_.update(controls.hand(), {toScreen(controls), seconds}, controls.parameters, trainer_->lesson().process);
    steps_ = {&controls, held, seconds, clock_.due(seconds, trainer_->timeStep(), beside_)};
    return true;
}

/// Runs what may find a fault of the machine, or a recording that is damaged: then the simulation stops.
void LessonSession::guarded(FunctionRef<void()> work) {
    try {
        work();
    } catch (const std::runtime_error& fault) {
        fault_ = fault.what();
        event("fault", fault_);
    }
}

void LessonSession::finishSteps() {
    if (fault_.empty())
        guarded([&] {
            if (replay_.shown()) return finishReplay();
            if (demonstration_.shown()) return demonstration_.reach(trainer_->time());
            keepMoment();
            cues_.update(*trainer_, sections_->attempt.forScore, steps_.seconds);
            const auto& bands = lesson_.technique;
            ghost_.update(*trainer_, sections_->attempt.forScore, cues_.strength(bands ? &*bands : nullptr),
                          steps_.seconds);
            if (judge_.update(*trainer_)) judge();
        });
    if (!played()) records_.check(*trainer_);
    steps_ = {};
}

/// Where another one leads the torch than in the last step, the arc goes out before the torch is elsewhere.
TorchSample LessonSession::nextTorch(const Controls& controls, const TorchSource& held, int step, int due) {
    if (std::exchange(handLed_, held_) != held_ && trainer_->torch().trigger > 0) {
        TorchSample out = trainer_->torch();
        out.trigger = 0;
        return out;
    }
    if (held_) return held(step, due);
    if (!desk_.leads()) return torchOf(controls.source(), fixture().turn);
    return desk_.next(step, due, trainer_->timeStep(), trainer_->burntOff(), controls.trigger());
}

/// Rotates directions of the workpiece's frame into the desk's view.
glm::mat3 LessonSession::toScreen(const Controls& controls) const {
    return glm::mat3(controls.view(1).worldToEye) * fixture().turn;
}

void LessonSession::makeSteps(gl::Profiler* profiler) {
    guarded([&] {
        timeSteps(steps_.due, [&](int step, int due) {
            surfaceIsOld_ = true;
            if (replay_.shown()) return replay_.step(*trainer_, profiler);
            if (demonstration_.shown()) return trainer_->advanceDemonstration(profiler);
            makeStep(step, due, profiler);
        });
    });
}

/// A step whose torch is in a hand.
void LessonSession::makeStep(int step, int due, gl::Profiler* profiler) {
    if (step == 0 && clock_.dropped() && trainer_->arc().burns())
        event("samples", droppedText(due * trainer_->timeStep()));
    trainer_->setRealTime(clock_.speed());
    TorchSample torch = nextTorch(*steps_.controls, steps_.held, step, due);
    // The other hand may be in sight without a rod in it.
    if (!holdsRod(trainer_->lesson().process)) torch.rod.reset();
    trainer_->advance(torch, profiler);
}

/// Makes the steps that `seconds` of real time are worth, as far as the machine bears.
void LessonSession::makeDueSteps(double seconds, FunctionRef<void(int step, int due)> make) {
    timeSteps(clock_.due(seconds, trainer_->timeStep()), make);
}

void LessonSession::timeSteps(int due, FunctionRef<void(int step, int due)> make) {
    const double begin = now_();
    for (int step = 0; step < due; ++step)
        make(step, due);
    clock_.took(now_() - begin, due);
}

} // namespace meltpool
