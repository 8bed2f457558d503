// The part of LessonSession that leads the metal's steps by the person's input of a frame.
#include "app/session/lesson_session.hpp"

#include "core/base/error.hpp"

#include <utility>

namespace meltpool {

/// No steps are made in view mode, while the weld is cut open, and before a question is answered. A hand's arc goes out
/// before the pause: it would burn on in the trainee's view, behind a dark visor.
bool LessonSession::waits(const Controls& controls) {
    const bool looks = controls.mode() == Mode::view;
    pausing_ = looks && leader() == TorchLeader::hand && run_.arc().burns() && run_.fault().empty();
    const bool pause = (looks && !pausing_) || picture_.cut().shown();
    if (pause != paused_) run_.event(pause ? "paused" : "resumed");
    paused_ = pause;
    return pause || question_.asked();
}

void LessonSession::advance(const Controls& controls, double seconds, gl::Profiler* profiler, const TorchSource& held) {
    if (!beginSteps(controls, seconds, profiler, held)) return;
    run_.makeSteps(profiler);
    run_.finishSteps();
}

bool LessonSession::beginSteps(const Controls& controls, double seconds, gl::Profiler* profiler,
                               const TorchSource& held) {
    if (!running()) {
        RunFrame frame;
        frame.seconds = seconds;
        run_.beginSteps(std::move(frame), sound_.soundSteps, profiler);
        return false;
    }
    const Allowed allowed = activities_.allowed();
    if (allowed.values) {
        values_.lesson().source.kind = controls.source().cold() ? 1 : 0;
        values_.apply(*run_.trainer());
        lead_.take(held && allowed.ownTorch);
    }
    picture_.beginFrame(seconds, allowed.values);
    moveCut(controls);
    controls_ = &controls;
    held_ = held;
    RunFrame frame{seconds, waits(controls), values_.forScore(),
                   [this](int step, int steps) { return nextTorch(step, steps); }};
    const bool due = run_.beginSteps(std::move(frame), sound_.soundSteps, profiler);
    if (activities_.trial.measuring() && !run_.fault().empty()) {
        activities_.trial.stop();
        question_ = {};
        return false;
    }
    nextTrial(activities_.trial.takeVerdict());
    const bool deskLeads = leader() == TorchLeader::desk;
    if (std::exchange(judgements_, attempt().judgements()) != judgements_ && attempt().judged())
        lead_.desk().putAside(); // it would hide the weld
    attempt().cues().setHeldByDesk(deskLeads ? lead_.desk().held() : QuantitySet());
    if (due && deskLeads) {
        const glm::mat3 toScreen = glm::mat3(controls.view(1).worldToEye) * picture_.fixture().turn;
        lead_.update(controls, toScreen, run_.secondsDue(), run_.trainer()->lesson().process);
        noteSwings();
    }
    return due;
}

/// Writes to the record that the desk swings its torch from now on, or no longer.
void LessonSession::noteSwings() {
    const DeskWeave& weave = lead_.desk().weave();
    attempt().cues().setSwings(weave.on());
    if (std::exchange(swings_, weave.on()) == weave.on()) return;
    run_.event("desk_swings", weave.on() ? "on" : "off");
}

void LessonSession::moveCut(const Controls& controls) {
    if (!picture_.cut().shown()) return;
    try {
        picture_.moveCut(controls);
    } catch (const RuntimeFault& fault) {
        run_.stop(fault.what());
    }
}

TorchSample LessonSession::nextTorch(int step, int steps) {
    TorchSample torch = lead_.next(*run_.trainer(), *controls_, held_, picture_.fixture().turn, step, steps);
    if (pausing_) torch.trigger = 0;
    return torch;
}

} // namespace meltpool
