#include "app/session/lesson_session.hpp"

#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/training/lesson/lesson_folders.hpp"
#include "core/training/trainer/classic_model.hpp"

#include <glm/trigonometric.hpp>

#include <chrono>
#include <utility>

namespace meltpool {

namespace {

bool same(const SurfaceParameters& a, const SurfaceParameters& b) {
    return a.influence == b.influence && a.isoLevel == b.isoLevel && a.caps == b.caps;
}

/// The lesson with its machine as the trainee finds it.
Lesson machineAtStart(Lesson lesson) {
    lesson.takeStartSettings();
    return lesson;
}

} // namespace

Lesson loadLesson(const std::string& name) {
    return findLesson(name, LessonFolders::ofUser());
}

double machineSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

LessonSession::LessonSession(gl::ShaderLibrary& shaders, Lesson lesson, Stopwatch stopwatch,
                             gl::OtherContext* metalThere)
    : shaders_(shaders),
      metalThere_(metalThere),
      given_(lesson.process),
      lesson_(machineAtStart(std::move(lesson))),
      sections_(std::in_place, lesson_),
      renderer_(shaders, cacheFolder()),
      now_(stopwatch) {
    openCues();
}

void LessonSession::open(Lesson lesson) {
    end("another lesson was opened");
    const bool forScore = sections_->attempt.forScore;
    given_ = lesson.process;
    lesson_ = machineAtStart(std::move(lesson));
    sections_.emplace(lesson_);
    sections_->attempt.forScore = forScore;
    openCues();
}

void LessonSession::openCues() {
    cues_.open(lesson_);
    cueSection_.idle = cues_.idle();
    ghost_.open(lesson_);
    ghostSection_.idle = ghost_.idle();
}

bool LessonSession::workpieceChanged() {
    return sections_->workpieceChanged(lesson_);
}

bool LessonSession::settingsChanged() const {
    return sections_->machineChanged(lesson_);
}

/// Ends what runs, and puts torch and camera to the lesson's places.
void LessonSession::prepare(Controls& controls) {
    end("another attempt began");
    controls.restart();
    controls.source().setCold(lesson_.source.kind == 1);
    desk_.begin(lesson_);
    controls.leadTorch(desk_.leads());
    const CameraParameters& camera = lesson_.camera;
    controls.placeCamera(OrbitCamera(glm::radians(camera.azimuth), glm::radians(camera.elevation), camera.distance));
    controls.lens.fieldOfView = glm::radians(camera.fieldOfView);
}

void LessonSession::begin(Controls& controls) {
    prepare(controls);
    sections_->restoreGiven();
    if (const std::string unset = lesson_.unsetSettings(); !unset.empty()) {
        question_ = {unset, {"Set the machine"}};
        return;
    }
    if (sections_->attempt.forScore) {
        trial_.begin(lesson_);
        beginTrial();
        return;
    }
    makeTrainer();
    beginAttempt();
}

/// `process`: other settings than those of the menus, which then change nothing.
void LessonSession::makeTrainer(const ProcessSettings* process) {
    trainer_.reset(); // its memory may be needed for the next
    Lesson lesson = lesson_;
    if (trial_.running())
        for (const auto& [key, value] : trial_.current().values)
            lesson.set(key, value, "a value that was offered");
    if (process != nullptr) lesson.process = *process;
    trainer_ = std::make_unique<Trainer>(shaders_, std::move(lesson), metalThere_);
    hearing_.ear.reset();
    if (!trial_.running()) trainer_->listen(&hearing_.ear);
    clock_.reset();
    if (process != nullptr) return;
    wanted_ = liveParameters(lesson_.metalParameters());
    running_ = liveParameters(trainer_->lesson().metalParameters());
}

void LessonSession::reset(Controls& controls) {
    if (!running() || !trial_.offers().empty()) return; // an attempt for score has not begun yet
    if (replay_.shown()) return begin(controls);
    const bool otherSettings = wanted_.empty(); // see makeTrainer()
    if (demonstration_.shown() && (sections_->attempt.forScore || otherSettings)) return begin(controls);
    demonstration_.end();
    closeCut(controls);
    controls.reset();
    desk_.begin(lesson_);
    tellRecordingJudgement();
    trainer_->reset();
    recordings_.close();
    records_.check(*trainer_); // the last lines of the record that ended
    clock_.restart();
    beginAttempt();
}

void LessonSession::judge() {
    if (!judges() || question_.asked() || !fault_.empty()) return;
    try {
        judge_.judge(*trainer_);
        if (const auto& judged = judge_.judged(); judged && judged->judgement.score && redo_.redone() == 0)
            cues_.practised(*judged->judgement.score);
    } catch (const RuntimeFault& fault) {
        fault_ = fault.what();
        event("fault", fault_);
    }
    clock_.restart(); // the metal does not make good the time that judging took
}

void LessonSession::beginAttempt() {
    cut_.close();
    judge_.forget();
    cues_.begin();
    ghost_.begin(*trainer_);
    surfaceDistance_ = {};
    fault_.clear();
    surfaceIsOld_ = true;
    paused_ = false;
    question_ = {};
    recordings_.begin(*trainer_, records_.attempt() + 1);
    beginMoments();
    try {
        records_.begin(*trainer_);
    } catch (const std::runtime_error& fault) { // no such place, or no room for even its head
        question_ = {std::string("This attempt cannot be recorded: ") + fault.what(),
                     {"Weld without a record", "Start menu"}};
    }
    if (sections_->attempt.forScore) event("for_score", "yes");
}

void LessonSession::settle(Controls& controls) {
    const int answer = std::exchange(question_.answered, -1);
    if (answer < 0 || !question_.asked()) return;
    question_ = {};
    if (!running()) return; // the machine is set on the lesson's first page
    if (!trial_.offers().empty()) return settleTrial(answer, controls);
    if (answer == 0) {
        records_.renounce();
        return;
    }
    end("start menu");
    controls.restart();
}

void LessonSession::end(std::string_view reason) noexcept {
    tellRecordingJudgement();
    question_ = {};
    judge_.forget();
    redo_.begin();
    cut_.close();
    trial_.stop();
    demonstration_.end();
    replay_.end();
    wanted_.clear();
    running_.clear();
    surfaceDistance_ = {};
    if (!running()) return;
    try {
        trainer_->stopRecord(reason);
        records_.check(*trainer_);
    } catch (const std::exception&) {
        records_.renounce(); // the metal cannot even be read any more
    }
    trainer_.reset();
    recordings_.close();
}

/// The attempt ends: its recording tells how it was judged, unless the weld went on after that.
void LessonSession::tellRecordingJudgement() {
    const auto& judged = judge_.judged();
    if (!judged) return recordings_.judged({}, {});
    const Judgement& judgement = judged->judgement;
    const bool scored = judgement.score && judgement.score->scored;
    const char* verdict = !judgement.verdict ? "" : judgement.verdict->accepted ? "accepted" : "not accepted";
    recordings_.judged(scored ? std::optional(judgement.score->total) : std::nullopt, verdict);
}

void LessonSession::event(std::string_view name, std::string_view value) {
    if (running() && !played()) trainer_->event(name, value); // what happens to the viewer is none of the attempt
}

const std::string& LessonSession::recordFault() const {
    static const std::string kNone;
    return running() ? trainer_->recordFault() : kNone;
}

bool LessonSession::takeOverChanges(const Controls& controls) {
    lesson_.source.kind = controls.source().cold() ? 1 : 0;
    for (size_t i = 0; i < wanted_.size(); ++i)
        if (!sameValue(wanted_[i], running_[i]))
            trainer_->change(wanted_[i].key, parameterText(wanted_[i]), "the menu");
    Lesson& running = trainer_->lesson();
    const bool changed = !same(shownSurface_, lesson_.surface);
    const bool detailed = running.look.detail != detail_; // decides what the surface holds
    running.surface = lesson_.surface;
    running.look.detail = detail_;
    shownSurface_ = lesson_.surface;
    return changed || detailed;
}

void LessonSession::sound(const TorchSample& torch) {
    if (!running()) return;
    if (const auto fresh = trainer_->pollDistance()) {
        surfaceDistance_ = *fresh;
        trainer_->setSurfaceDistance(surfaceDistance_);
    }
    trainer_->requestDistance(torch);
}

} // namespace meltpool
