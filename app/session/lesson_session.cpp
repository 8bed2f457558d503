#include "app/session/lesson_session.hpp"

#include "core/base/error.hpp"
#include "core/base/words.hpp"
#include "core/training/lesson/lesson_folders.hpp"

#include <chrono>
#include <cmath>
#include <utility>

namespace meltpool {

Lesson loadLesson(const std::string& name) {
    return findLesson(name, LessonFolders::ofUser());
}

double machineSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

LessonSession::LessonSession(gl::ShaderLibrary& shaders, Lesson lesson, Stopwatch stopwatch,
                             gl::ContextThread* metalThread)
    : values_(std::move(lesson)),
      run_(shaders, activities_, stopwatch, metalThread),
      picture_(shaders, {values_.lesson(), run_, activities_, lead_}),
      help_{{"cues", describe(attempt().cues().parameters)},
            {"sound", describe(sound_.parameters)},
            {"ghost", describe(attempt().ghost().parameters)}} {
    openHelp();
}

void LessonSession::open(Lesson lesson) {
    end("another lesson was opened");
    values_.open(std::move(lesson));
    openHelp();
}

void LessonSession::openHelp() {
    attempt().open(lesson());
    help_.cues.idle = attempt().cues().idle();
    help_.ghost.idle = attempt().ghost().idle();
}

/// Ends the running lesson, and moves torch and camera to the lesson's places.
void LessonSession::prepare(Controls& controls) {
    end("another attempt began");
    controls.restart();
    controls.source().setCold(lesson().source.kind == 1);
    lead_.begin(lesson());
    attempt().cues().setSwings(false);
    controls.leadTorch(lead_.desk().leads());
    picture_.placeCamera(controls);
}

void LessonSession::begin(Controls& controls) {
    prepare(controls);
    sections().restoreGiven();
    if (const std::string unset = values_.lesson().unsetSettings(); !unset.empty()) {
        question_ = {unset, {phrase("session.set_machine")}};
        return;
    }
    if (values_.forScore()) {
        activities_.trial.begin(lesson());
        beginTrial();
        return;
    }
    makeMetal();
    beginAttempt();
}

/// Makes the metal. `process`: settings other than the menus', which then have no effect.
void LessonSession::makeMetal(const ProcessSettings* process) {
    run_.free();
    Lesson made = lesson();
    const SpeedTrial& trial = activities_.trial;
    if (trial.measuring())
        for (const auto& [key, value] : trial.current().values)
            made.set(key, value, "an offered value");
    if (process != nullptr) made.process = *process;
    made.torch = values_.pathOfExpert();
    run_.make(std::move(made));
    sound_.soundSteps.reset();
    if (!trial.measuring()) run_.trainer()->listen(&sound_.soundSteps);
    if (process == nullptr) values_.follow(*run_.trainer());
}

/// Turns to this activity, over metal in its start state.
void LessonSession::beginOver(Activity& activity) {
    activities_.turnTo(activity);
    run_.beginAgain();
}

void LessonSession::beginAttempt() {
    picture_.cut().close();
    run_.forgetSurfaceDistance();
    paused_ = pausing_ = swings_ = false;
    question_ = {};
    beginOver(attempt());
    askAboutRecord(attempt().begin(*run_.trainer(), values_.forScore()));
}

/// `fault`: reason why the attempt has no record; empty: it has one, or none is wanted.
void LessonSession::askAboutRecord(const std::string& fault) {
    if (!fault.empty())
        question_ = {phrase("session.no_record", {{"reason", fault}}),
                     {phrase("session.without_record"), phrase("session.start_menu")}};
}

void LessonSession::demonstrate(Controls& controls) {
    if (!(lesson().torch.duration() > 0)) return;
    prepare(controls);
    makeMetal(values_.machineChosen() ? &values_.given() : nullptr);
    beginOver(activities_.demonstration);
    activities_.demonstration.begin(lesson().torch.duration(), !values_.followed());
}

void LessonSession::openReplay(Lesson attempt, Controls& controls) {
    prepare(controls);
    attempt.surface = lesson().surface; // the viewer chooses how it is shown
    run_.make(std::move(attempt));
    sound_.soundSteps.reset();
    beginOver(activities_.replay);
    activities_.replay.begin(*run_.trainer(), thisMachine(), run_.stopwatch());
}

void LessonSession::compare(const AttemptComparison::Side& first, const AttemptComparison::Side& second) {
    if (running()) end("two attempts are compared");
    if (second.file.empty())
        activities_.comparison.tryChange(first);
    else
        activities_.comparison.begin(first, second);
    activities_.turnTo(activities_.comparison);
}

void LessonSession::reset(Controls& controls) {
    switch (activities_.current().nextAttempt(values_.forScore())) {
    case NextAttempt::none:
        return;
    case NextAttempt::freshMetal:
        return begin(controls);
    case NextAttempt::sameMetal:
        break;
    }
    activities_.demonstration.end();
    closeCut(controls);
    controls.reset();
    lead_.begin(lesson());
    run_.trainer()->lesson().torch = values_.pathOfExpert(); // the hand may have changed
    attempt().reset(*run_.trainer());
    run_.clock().restart();
    beginAttempt();
}

void LessonSession::settle(Controls& controls) {
    const int answer = std::exchange(question_.answered, -1);
    if (answer < 0 || !question_.asked()) return;
    question_ = {};
    if (!running()) return; // without a running lesson the machine is set on its first page
    if (activities_.at(activities_.trial)) return settleTrial(answer, controls);
    if (answer == 0) {
        log().records().renounce();
        return;
    }
    end("start menu");
    controls.restart();
}

void LessonSession::end(std::string_view reason) noexcept {
    question_ = {};
    picture_.cut().close();
    activities_.end();
    values_.unfollow();
    run_.forgetSurfaceDistance();
    if (run_.trainer() == nullptr) return;
    log().stop(*run_.trainer(), reason);
    run_.free();
    log().close();
}

void LessonSession::judge() {
    if (!judges() || question_.asked() || !run_.fault().empty()) return;
    run_.guarded([&] { attempt().judge(*run_.trainer()); });
    run_.clock().restart(); // the metal does not catch up on the time that judging took
}

/// An attempt for score is welded once, from beginning to end.
bool LessonSession::redoes() {
    return judges() && !values_.forScore() && !question_.asked() && run_.fault().empty() && log().redo().can();
}

void LessonSession::redo(Controls& controls) {
    if (!redoes()) return;
    closeCut(controls);
    std::string unrecorded;
    try {
        if (!attempt().beginFromCheckpoint(*run_.trainer(), unrecorded)) return;
    } catch (const std::exception& fault) { // the metal may belong to neither checkpoint
        run_.stop(fault.what());
        run_.event("fault", run_.fault());
        return;
    }
    controls.putOut(ArcOut::redone);
    const double place = run_.trainer()->technique()->place();
    if (lead_.desk().leads() && std::isfinite(place)) lead_.desk().standAt(place);
    run_.forgetSurfaceDistance();
    run_.metalChanged();
    run_.clock().restart();
    askAboutRecord(unrecorded);
}

bool LessonSession::cuts() const {
    return judges() && (!run_.arc().burns() || paused_) && !question_.asked() && run_.fault().empty() &&
           CutView::canCut(run_.trainer()->lesson());
}

void LessonSession::toggleCut(Controls& controls) {
    if (picture_.cut().shown()) return closeCut(controls);
    if (!cuts()) return;
    try {
        picture_.openCut(controls);
    } catch (const RuntimeFault& fault) {
        run_.stop(fault.what());
        return;
    }
    run_.event("cut", "open");
}

void LessonSession::closeCut(Controls& controls) {
    if (picture_.closeCut(controls)) run_.event("cut", "closed");
}

} // namespace meltpool
