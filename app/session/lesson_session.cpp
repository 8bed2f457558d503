#include "app/session/lesson_session.hpp"

#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/training/classic_model.hpp"

#include <glm/gtc/constants.hpp>
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

Lesson loadLesson(const std::string& name) {
    return findLesson(name, resourceFolder() / "data" / "lessons");
}

double machineSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

LessonSession::LessonSession(gl::ShaderLibrary& shaders, Lesson lesson, Stopwatch stopwatch)
    : shaders_(shaders),
      given_(lesson.process),
      lesson_(machineAtStart(std::move(lesson))),
      sections_(std::in_place, lesson_),
      renderer_(shaders),
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
    trainer_ = std::make_unique<Trainer>(shaders_, std::move(lesson));
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
    running.surface = lesson_.surface;
    shownSurface_ = lesson_.surface;
    return changed;
}

/// No steps are made in view mode, while the weld is cut open, after a fault and before a question is answered.
bool LessonSession::waits(const Controls& controls) {
    const bool pause = (controls.mode() == Mode::view && !held_) || cut_.shown();
    if (pause != paused_) event(pause ? "paused" : "resumed");
    paused_ = pause;
    return pause || !fault_.empty() || question_.asked();
}

void LessonSession::advance(const Controls& controls, double seconds, gl::Profiler* profiler, const TorchSource& held) {
    if (!running()) return;
    if (trial_.running()) return measureSpeed(seconds, profiler);
    surfaceIsOld_ |= takeOverChanges(controls);
    held_ = static_cast<bool>(held) && !played();
    if (replay_.shown()) return playReplay(seconds, profiler);
    if (demonstration_.shown()) return playDemonstration(seconds, profiler);
    if (cut_.shown()) inspect(controls);
    if (waits(controls)) {
        clock_.restart();
        return;
    }
    try {
        makeSteps(controls, seconds, profiler, held);
        keepMoment();
        cues_.update(*trainer_, sections_->attempt.forScore, seconds);
        const auto& bands = lesson_.technique;
        ghost_.update(*trainer_, sections_->attempt.forScore, cues_.strength(bands ? &*bands : nullptr), seconds);
        if (judge_.update(*trainer_)) judge();
    } catch (const RuntimeFault& fault) {
        fault_ = fault.what();
        event("fault", fault_);
    }
    records_.check(*trainer_);
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

void LessonSession::makeSteps(const Controls& controls, double seconds, gl::Profiler* profiler,
                              const TorchSource& held) {
    if (!held_)
        desk_.update(controls.hand(), {toScreen(controls), seconds}, controls.parameters, trainer_->lesson().process);
    makeDueSteps(seconds, [&](int step, int due) {
        if (step == 0 && clock_.dropped() && trainer_->arc().burns()) event("samples", "dropped");
        trainer_->setRealTime(clock_.speed());
        TorchSample torch = nextTorch(controls, held, step, due);
        // The other hand may be in sight without a rod in it.
        if (!holdsRod(trainer_->lesson().process)) torch.rod.reset();
        trainer_->advance(torch, profiler);
        surfaceIsOld_ = true;
    });
}

/// Makes the steps that `seconds` of real time are worth, as far as the machine bears.
void LessonSession::makeDueSteps(double seconds, FunctionRef<void(int step, int due)> make) {
    const double begin = now_();
    const int due = clock_.due(seconds, trainer_->timeStep());
    for (int step = 0; step < due; ++step)
        make(step, due);
    clock_.took(now_() - begin, due);
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
