#include "app/session/lesson_session.hpp"

#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/training/classic_model.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace meltpool {

namespace {

ParameterList workpieceParameters(Lesson& lesson) {
    return lesson.model == LessonModel::Weld ? describe(lesson.workpiece) : describe(lesson.setup);
}

ParameterList startParameters(Lesson& lesson, AttemptParameters& attempt) {
    ParameterList list = describe(attempt);
    for (const Parameter& p : workpieceParameters(lesson))
        if (p.key != "seed") list.push_back(p);
    for (const Parameter& p : describe(lesson.surface))
        if (p.onlyAtStart || p.key == "influence") list.push_back(p);
    return list;
}

ParameterList liveParameters(ParameterList list) {
    std::erase_if(list, [](const Parameter& p) { return p.onlyAtStart; });
    return list;
}

/// Keys of the look that change nothing in this lesson.
std::span<const std::string_view> idleLook(const Lesson& lesson) {
    static constexpr std::array<std::string_view, 3> kIdle{"arc_light", "material", "show_source"};
    const std::span<const std::string_view> all(kIdle);
    if (lesson.model == LessonModel::Classic) return all.first(1); // no arc
    return isArcWelding(lesson.process) ? all.last(2) : all;
}

bool same(const SurfaceParameters& a, const SurfaceParameters& b) {
    return a.influence == b.influence && a.isoLevel == b.isoLevel && a.caps == b.caps;
}

/// The lesson with its machine as the trainee finds it.
Lesson machineAtStart(Lesson lesson) {
    lesson.takeStartSettings();
    return lesson;
}

bool sameSettings(ProcessSettings a, ProcessSettings b) {
    const ParameterList first = describe(a), second = describe(b);
    return a.kind == b.kind && std::equal(first.begin(), first.end(), second.begin(), second.end(), sameValue);
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

ParameterList describe(AttemptParameters& a) {
    return {{"for_score",
             "For score",
             "",
             &a.forScore,
             0,
             1,
             "the lesson starts only where this machine keeps up with the clock; measured before each start",
             {},
             true}};
}

LessonSections::LessonSections(Lesson& lesson)
    : start("start", startParameters(lesson, attempt)),
      view("view", describe(lesson.look)),
      surface("surface", liveParameters(describe(lesson.surface))),
      simulation("simulation", liveParameters(lesson.model == LessonModel::Weld ? lesson.processParameters()
                                                                                : describe(lesson.metal))) {
    static constexpr std::array<std::string_view, 1> kStart{"for_score"};
    static constexpr std::array<std::string_view, 2> kFlame{"heat_radius", "heat_temperature"};
    view.idle = idleLook(lesson);
    start.everyday = kStart;
    if (lesson.model == LessonModel::Classic) simulation.everyday = kFlame;
    if (lesson.model == LessonModel::Weld) simulation.fixed = &attempt.forScore;
    for (const ChosenSetting& each : lesson.choose) {
        simulation.chosen.push_back(each.key);
        // What may not be chosen is nothing to go back to.
        if (each.start && (*each.start < each.from || *each.start > each.to)) simulation.defaults.erase(each.key);
    }
}

void LessonSections::restoreDefaults() {
    for (const ParameterSection* each : all())
        for (const auto& [key, text] : each->defaults)
            setParameter(each->parameters, key, text, each->name);
}

void LessonSections::restoreGiven() {
    for (const Parameter& p : simulation.parameters)
        if (simulation.isGiven(p)) setParameter({p}, p.key, simulation.defaults.at(std::string(p.key)), "given");
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
}

bool LessonSession::workpieceChanged() {
    const ParameterList now = workpieceParameters(lesson_);
    return std::any_of(now.begin(), now.end(), [this](const Parameter& p) {
        const auto first = sections_->start.defaults.find(p.key);
        return first != sections_->start.defaults.end() && first->second != parameterText(p);
    });
}

bool LessonSession::settingsChanged() const {
    const ParameterSection& machine = sections_->simulation;
    return lesson_.model == LessonModel::Weld &&
           std::any_of(machine.parameters.begin(), machine.parameters.end(), [&](const Parameter& p) {
               const auto first = machine.defaults.find(p.key);
               const bool chosen =
                   std::find(machine.chosen.begin(), machine.chosen.end(), p.key) != machine.chosen.end();
               return !chosen && first != machine.defaults.end() && first->second != parameterText(p);
           });
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

void LessonSession::demonstrate(Controls& controls) {
    if (!hasDemonstration()) return;
    prepare(controls);
    makeTrainer(lesson_.choose.empty() || sameSettings(lesson_.process, given_) ? nullptr : &given_);
    fault_.clear();
    surfaceIsOld_ = true;
    demonstration_.begin(lesson_.torch.duration());
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
    clock_.reset();
    if (process != nullptr) return;
    wanted_ = liveParameters(lesson_.metalParameters());
    running_ = liveParameters(trainer_->lesson().metalParameters());
}

/// Makes the metal of the trial's current offer, and finds where its demonstration begins to heat.
void LessonSession::beginTrial() {
    makeTrainer();
    fault_.clear();
    surfaceIsOld_ = true;
    question_ = {};
    question_.text = "Measuring whether this machine keeps up with the clock";
    question_.text += trial_.current().label.empty() ? " ..." : ", with " + trial_.current().label + " ...";
    trialTime_ = lesson_.torch.firstPull().value_or(0);
}

void LessonSession::measureSpeed(double seconds, gl::Profiler* profiler) {
    const double before = trialTime_;
    makeDueSteps(seconds, [&](int, int) {
        trainer_->advance(lesson_.torch.sample(trialTime_ += trainer_->timeStep()), profiler);
    });
    surfaceIsOld_ = true;
    nextTrial(trial_.count(seconds, trialTime_ - before));
}

void LessonSession::nextTrial(SpeedTrial::Verdict verdict) {
    while (verdict == SpeedTrial::Verdict::another) {
        try {
            return beginTrial();
        } catch (const InputError&) { // a workpiece may have no room for such coarse particles
            verdict = trial_.skip();
        }
    }
    if (verdict == SpeedTrial::Verdict::tooSlow) question_ = trial_.question();
    if (verdict != SpeedTrial::Verdict::fastEnough) return;
    makeTrainer();
    beginAttempt();
}

void LessonSession::settleTrial(int answer, Controls& controls) {
    const std::vector<SpeedOffer> offers = trial_.offers();
    trial_.stop();
    if (static_cast<size_t>(answer) + 1 < offers.size()) {
        for (const auto& [key, value] : offers[static_cast<size_t>(answer) + 1].values)
            lesson_.set(key, value, "a value that was offered");
        begin(controls);
    } else if (static_cast<size_t>(answer) + 1 == offers.size()) {
        sections_->attempt.forScore = false;
        begin(controls);
    } else {
        end("start menu");
        controls.restart();
    }
}

void LessonSession::reset(Controls& controls) {
    if (!running() || !trial_.offers().empty()) return; // an attempt for score has not begun yet
    const bool otherSettings = wanted_.empty();         // see makeTrainer()
    if (demonstration_.shown() && (sections_->attempt.forScore || otherSettings)) return begin(controls);
    demonstration_.end();
    closeCut(controls);
    controls.reset();
    desk_.begin(lesson_);
    trainer_->reset();
    records_.check(*trainer_); // the last lines of the record that ended
    clock_.restart();
    beginAttempt();
}

void LessonSession::judge() {
    if (!judges() || question_.asked() || !fault_.empty()) return;
    try {
        judge_.judge(*trainer_);
        if (const auto& judged = judge_.judged(); judged && judged->judgement.score)
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
    surfaceDistance_ = {};
    fault_.clear();
    surfaceIsOld_ = true;
    paused_ = false;
    question_ = {};
    try {
        records_.begin(*trainer_);
        if (sections_->attempt.forScore) event("for_score", "yes");
    } catch (const std::runtime_error& fault) { // no such place, or no room for even its head
        question_ = {std::string("This attempt cannot be recorded: ") + fault.what(),
                     {"Weld without a record", "Start menu"}};
    }
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
    question_ = {};
    judge_.forget();
    cut_.close();
    trial_.stop();
    demonstration_.end();
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
}

void LessonSession::event(std::string_view name, std::string_view value) {
    if (running()) trainer_->event(name, value);
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
    held_ = static_cast<bool>(held) && !demonstration_.shown();
    if (demonstration_.shown()) return playDemonstration(seconds, profiler);
    if (cut_.shown()) inspect(controls);
    if (waits(controls)) {
        clock_.restart();
        return;
    }
    try {
        makeSteps(controls, seconds, profiler, held);
        cues_.update(*trainer_, sections_->attempt.forScore, seconds);
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

void LessonSession::playDemonstration(double seconds, gl::Profiler* profiler) {
    try {
        if (demonstration_.takeMetalDue()) {
            trainer_->reset();
            clock_.restart();
            fault_.clear();
            surfaceIsOld_ = true;
        }
        if (!demonstration_.playing() || !fault_.empty()) {
            clock_.restart();
        } else if (demonstration_.welds()) {
            makeDueSteps(seconds, [&](int, int) {
                trainer_->advanceDemonstration(profiler);
                surfaceIsOld_ = true;
            });
            demonstration_.reach(trainer_->time());
        } else {
            demonstration_.reach(demonstration_.time() + seconds);
        }
        if (!demonstration_.welds()) trainer_->show(lesson_.torch.sample(demonstration_.time()));
    } catch (const RuntimeFault& fault) {
        fault_ = fault.what();
    }
}

void LessonSession::sound(const TorchSample& torch) {
    if (!running()) return;
    if (const auto fresh = trainer_->pollDistance()) {
        surfaceDistance_ = *fresh;
        trainer_->setSurfaceDistance(surfaceDistance_);
    }
    trainer_->requestDistance(torch);
}

SceneView LessonSession::scene(gl::Profiler* profiler) {
    if (!running()) return {};
    // The vibration needs the surface also while the particles are shown.
    if (surfaceIsOld_ && (held_ || lesson_.look.mode != kPointsMode)) {
        trainer_->updateSurface(profiler);
        surfaceIsOld_ = false;
    }
    SceneView scene = trainer_->scene();
    if (cut_.shown()) {
        scene.section = cut_.view();
        scene.solids = {};
        scene.rodSolids = 0;
    }
    return scene;
}

std::span<const Marker> LessonSession::cueMarkers(const SceneView& scene, const View& eye) {
    if (!running() || demonstration_.shown() || trial_.running() || cut_.shown()) return {};
    return cues_.markers(*trainer_, scene, eye);
}

float LessonSession::unit() const {
    return kClassicUnit;
}

Fixture LessonSession::fixture() const {
    if (!running() || lesson_.model != LessonModel::Weld) return {};
    return fixtureOf(trainer_->lesson().workpiece);
}

float LessonSession::bottom() const {
    if (!running()) return 0.0f;
    const SceneView scene = trainer_->scene();
    // Along the world's vertical each axis of the box has its lower end.
    const glm::vec3 vertical = glm::row(glm::mat3(scene.modelToWorld), 1);
    const glm::vec3 lowest = glm::mix(scene.boxMax, scene.boxMin, glm::greaterThan(vertical, glm::vec3(0)));
    return (glm::dot(vertical, lowest) + scene.modelToWorld[3].y) * unit();
}

void LessonSession::draw(const Controls& controls, glm::ivec2 pixels, float shift, gl::Profiler* profiler) {
    SceneView scene = this->scene(profiler);
    if (!held_ && !demonstration_.shown()) {
        const SteeredSource& source = controls.source();
        scene.source.position = glm::inverse(scene.modelToWorld) * glm::vec4(source.position(), 1);
        scene.source.on = source.on();
        scene.source.cold = source.cold();
    }
    const float aspect = static_cast<float>(pixels.x) / static_cast<float>(std::max(pixels.y, 1));
    std::array<View, 1> views{controls.view(aspect)};
    if (cut_.shown()) { // its middle stands where the camera looks
        const glm::vec3 middle = scene.modelToWorld * glm::vec4(scene.section.at, 0, 0, 1);
        views[0].worldToEye = glm::translate(views[0].worldToEye, -middle);
        views[0].eye += middle;
        scene.section.strokes = cut_.strokes(layoutIn(views[0], scene.modelToWorld, scene.section.at));
    }
    views[0].eyeToClip[2][0] -= shift; // clip x over w, and w is -z in the eye
    scene.markers = cueMarkers(scene, views[0]);
    renderer_.draw(scene, lesson_.look, views, {0, {0, 0, pixels.x, pixels.y}}, profiler);
}

void LessonSession::fillFigures(LessonFigures& figures) const {
    if (!running()) return;
    const MetalStatistics& metal = trainer_->figures();
    figures.time = trainer_->time();
    figures.speed = clock_.speed();
    figures.particles = metal.particles;
    figures.molten = metal.molten;
    figures.hottest = metal.maxTemperature;
    figures.kelvin = lesson_.model == LessonModel::Weld;
    figures.lost = metal.lost;
    figures.refused = metal.nonFinite;
    figures.stopped = !fault_.empty();
    const bool desk = desk_.leads() && !held_ && !demonstration_.shown();
    figures.torch = desk ? std::optional(desk_.pose()) : std::nullopt;
    figures.distance = desk_.distanceKind();
}

} // namespace meltpool
