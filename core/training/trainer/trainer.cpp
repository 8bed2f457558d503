#include "core/training/trainer/trainer.hpp"

#include "core/base/error.hpp"
#include "core/base/last_facts.hpp"
#include "core/base/text.hpp"

#include <utility>

namespace meltpool {

Trainer::Trainer(gl::ShaderLibrary& shaders, Lesson lesson, gl::ContextThread* metalThread)
    : lesson_(std::move(lesson)),
      metal_(shaders, lesson_, metalThread),
      identity_(identityOf(lesson_)),
      live_(liveParameters(lesson_)),
      figures_(metal_, recorder_) {
    noteFact(LastFact::lesson, lesson_.key);
    torch_ = lesson_.torch.sample(0);
    torch_.trigger = 0;
    if (lesson_.model != LessonModel::Weld) return;
    technique_.emplace(techniqueOf(lesson_.workpiece, lesson_.process, lesson_.technique));
    sound_.setAlternating(workpieceMaterial(lesson_.workpiece).alternatingCurrent);
}

Trainer::~Trainer() = default;

void Trainer::reset() {
    stopRecord("reset");
    if (lesson_.recorded) // the changes come again
        for (const RecordedChange& value : lesson_.recorded->values)
            lesson_.set(value.key, value.value, "a recorded value");
    metal_.change([this](MetalModel& metal) {
        metal.apply(lesson_); // values set since the last step hold from the start
        metal.reset();
    });
    time_ = 0;
    steps_ = 0;
    nextChange_ = 0;
    nextEvent_ = 0;
    figures_.reset();
    arc_ = {};
    sound_.reset();
    if (watcher_ != nullptr) watcher_->beganAgain();
    recorder_.reset();
    account_ = {};
    surfaceDistance_ = {};
    tracked_ = true;
    if (technique_) technique_->reset();
}

void Trainer::applyValues() {
    metal_.run([this](MetalModel& metal) { metal.apply(lesson_); });
}

std::uint64_t Trainer::stateHash() const {
    return metal_.run([](MetalModel& metal) { return metal.stateHash(); });
}

double Trainer::timeStep() const {
    return metal_.model().timeStep();
}

void Trainer::change(std::string_view key, std::string_view value, std::string_view where) {
    lesson_.set(key, value, where);
    recorder_.change(steps_, key, value);
}

void Trainer::event(std::string_view name, std::string_view value) {
    if (name == "torch") tracked_ = value != "lost";
    if (name == "samples" && technique_) technique_->noteDropped(droppedSeconds(value));
    recorder_.event(steps_, name, value);
}

void Trainer::advance(const TorchSample& torch, gl::Profiler* profiler) {
    applyValues();
    time_ += timeStep();
    torch_ = torch;
    torch_.time = time_;
    metal_.step(torch_, profiler);
    const bool burned = arc_.burns();
    arc_ = metal_.model().arc(surfaceDistance_);
    ++steps_;
    if (technique_) technique_->add(torch_, arc_, tracked_);
    account_.add(arc_, timeStep());
    recorder_.step(steps_, torch_, arc_);
    if (burned && wentOut(arc_.noArc)) event("arc_out", noArcName(arc_.noArc));
    figures_.update(time_);
    tellOfStep();
}

/// Comes after the figures: a run that waits for them reads those of its own step.
void Trainer::tellOfStep() {
    if (lesson_.model != LessonModel::Weld) return;
    sound_.step(lesson_.process, arc_, torch_, timeStep(), figures_.newest().maxTemperature);
    if (soundSteps_ != nullptr) soundSteps_->hear(sound_.last());
    if (watcher_ != nullptr) watcher_->stepped();
}

/// Events of a torch path from outside: a record has them itself.
void Trainer::followUnseen() {
    const std::optional<TorchForm>& form = lesson_.torch.form();
    if (!form || form->unseenRows == 0) return;
    const bool seen = demonstration().seen;
    if (seen != tracked_) event("torch", seen ? "seen" : "lost");
}

void Trainer::applyRecordedChanges() {
    if (!lesson_.recorded) return followUnseen();
    const std::vector<RecordedChange>& changes = lesson_.recorded->changes;
    for (; nextChange_ < changes.size() && changes[nextChange_].steps <= steps_; ++nextChange_)
        change(changes[nextChange_].key, changes[nextChange_].value, "a recorded change");
    const std::vector<RecordedEvent>& events = lesson_.recorded->events;
    for (; nextEvent_ < events.size() && events[nextEvent_].steps <= steps_; ++nextEvent_)
        event(events[nextEvent_].name, events[nextEvent_].value);
    applyValues(); // the step's length may be among the changes
}

void Trainer::advanceDemonstration(gl::Profiler* profiler) {
    applyRecordedChanges();
    advance(demonstration(), profiler);
}

AttemptHead Trainer::attemptHead() {
    AttemptHead head;
    head.lesson = lesson_.key;
    for (const Parameter& parameter : lesson_.metalParameters())
        head.values.emplace_back(parameter.key, parameterText(parameter));
    for (const ChosenSetting& each : lesson_.choose)
        head.chosen.push_back(each.key);
    head.arc = lesson_.model == LessonModel::Weld;
    head.rod = metal_.model().takesRod();
    return head;
}

void Trainer::record(const std::filesystem::path& file, const RecordContext& context) {
    figures_.finish();
    if (recorder_.writesCsv()) recorder_.endCsv("another record began", stateHash());
    AttemptHead head = attemptHead();
    head.attempt = context.attempt;
    head.program = context.program;
    head.driver = context.driver;
    head.person = context.person;
    head.personId = context.personId;
    recorder_.writeCsv(file, head, {context.paced, context.replace, context.from});
}

void Trainer::stopRecord(std::string_view reason) {
    figures_.finish();
    if (recorder_.writes()) recorder_.end(reason, stateHash(), steps_, time_);
}

LessonResult Trainer::result() const {
    const MetalStatistics metal = metal_.run([](MetalModel& model) { return model.statistics(); });
    return {time_, steps_, metal, stateHash(), metal_.bytes(), metal_.model().wire()};
}

Judgement Trainer::judge() const {
    if (!technique_) return {};
    StationSettings stations;
    if (const auto& bands = lesson_.technique) {
        stations.seam = FaceStretch{bands->lengthFromMm * 1e-3, bands->lengthToMm * 1e-3};
        stations.ends = 0; // the lesson says what counts, and start and crater may lie in it
    }
    if (const auto range = weldedRange(*technique_)) {
        stations.passed = range->stretch;
        stations.stop = range->stop;
    }
    Judgement judgement = judgeAttempt(
        *technique_, metal_.run([&](MetalModel& metal) { return metal.measureWeld(stations); }),
        {lesson_.technique, lesson_.acceptance, lesson_.nominalWeld(), lesson_.process, lesson_.settingFacts()});
    judgement.arc = account_;
    judgement.realTime = recorder_.realTime();
    return judgement;
}

std::optional<WeldSection> Trainer::section(std::optional<double> place) const {
    if (!place)
        for (const PictureLook& picture : lesson_.pictures)
            if (picture.sectionAt) place = static_cast<double>(*picture.sectionAt);
    return metal_.run([&](MetalModel& metal) { return metal.section(place); });
}

} // namespace meltpool
