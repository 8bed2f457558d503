#include "core/training/trainer/trainer.hpp"

#include "core/base/error.hpp"
#include "core/base/last_facts.hpp"
#include "core/base/text.hpp"
#include "core/training/trainer/body_mesh.hpp"
#include "core/training/trainer/metal_elsewhere.hpp"

#include <utility>

namespace meltpool {

namespace {

/// Simulated time between two looks at all of the metal, s: as often as anybody can read figures. A record has the
/// newest.
constexpr double kFiguresPeriod = 0.1;

} // namespace

Trainer::Trainer(gl::ShaderLibrary& shaders, Lesson lesson, gl::OtherContext* metalThere)
    : lesson_(std::move(lesson)),
      metal_(metalThere != nullptr ? std::make_unique<MetalElsewhere>(*metalThere, lesson_)
                                   : makeMetalModel(shaders, lesson_)),
      identity_(identityOf(lesson_)),
      live_(liveParameters(lesson_)),
      probe_(shaders) {
    noteFact(LastFact::lesson, lesson_.key);
    const SceneView scene = metal_->scene({});
    surface_ = std::make_unique<Surface>(shaders, lesson_.surface, scene.boxMin, scene.boxMax);
    torch_ = lesson_.torch.sample(0);
    torch_.trigger = 0;
    figures_ = metal_->statistics();
    if (lesson_.model != LessonModel::Weld) return;
    sight_.open(scene);
    technique_.emplace(techniqueOf(lesson_.workpiece, lesson_.process, lesson_.technique));
    // Aluminium is welded with alternating current, which breaks its oxide.
    sound_.setAlternating(std::string_view(lesson_.workpiece.metal).starts_with("aluminium"));
}

Trainer::~Trainer() = default;

void Trainer::reset() {
    stopRecord("reset");
    awaitFigures();
    if (lesson_.recorded) // its changes come again
        for (const RecordedChange& value : lesson_.recorded->values)
            lesson_.set(value.key, value.value, "a recorded value");
    metal_->apply(lesson_); // what was set since the last step holds from the start
    metal_->reset();
    time_ = 0;
    steps_ = 0;
    nextFigures_ = 0;
    nextChange_ = 0;
    nextEvent_ = 0;
    figures_ = metal_->statistics();
    arc_ = {};
    sound_.reset();
    sight_.reset();
    pace_ = {};
    account_ = {};
    surfaceDistance_ = {};
    tracked_ = true;
    if (technique_) technique_->reset();
}

double Trainer::timeStep() const {
    return metal_->timeStep();
}

void Trainer::change(std::string_view key, std::string_view value, std::string_view where) {
    lesson_.set(key, value, where);
    if (record_) record_->change(key, value);
    if (recording_) recording_->change(steps_, key, value);
}

void Trainer::event(std::string_view name, std::string_view value) {
    if (name == "torch") tracked_ = value != "lost";
    if (name == "samples" && technique_) technique_->noteDropped(droppedSeconds(value));
    if (record_) record_->event(name, value);
    if (recording_) recording_->event(steps_, name, value);
}

void Trainer::advance(const TorchSample& torch, gl::Profiler* profiler) {
    metal_->apply(lesson_);
    time_ += timeStep();
    torch_ = torch;
    torch_.time = time_;
    metal_->step(torch_, profiler);
    const bool burned = arc_.burns();
    arc_ = metal_->arc(surfaceDistance_);
    ++steps_;
    if (technique_) technique_->add(torch_, arc_, tracked_);
    pace_.add(realTime_);
    account_.add(arc_, timeStep());
    if (record_) record_->add({torch_, arc_, realTime_});
    if (recording_) recording_->step({steps_, torch_, arc_, realTime_});
    if (burned && wentOut(arc_.noArc)) event("arc_out", noArcName(arc_.noArc));
    updateFigures();
    hearAndSee();
}

/// After the figures: a run that waits for them hears those of its own step.
void Trainer::hearAndSee() {
    if (lesson_.model != LessonModel::Weld) return;
    sound_.step(lesson_.process, arc_, torch_, timeStep(), figures_.maxTemperature);
    if (ear_ != nullptr) ear_->hear(sound_.last());
    sight_.step(lesson_.process, sound_.last(), torch_, steps_);
}

/// Of a path that people brought: a record has these events itself.
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
    metal_->apply(lesson_); // the step's length may be among the changes
}

void Trainer::advanceDemonstration(gl::Profiler* profiler) {
    applyRecordedChanges();
    advance(demonstration(), profiler);
}

void Trainer::updateFigures() {
    if (wait_) {
        awaitFigures();
        takeFigures(metal_->statistics());
        return;
    }
    while (const auto fresh = asked_ > 0 ? metal_->pollStatistics() : std::nullopt) {
        --asked_;
        takeFigures(*fresh);
    }
    if (record_)
        awaitFigures(kStatisticsInFlight - 1); // each of its rows has its own look at the metal
    else if (asked_ > 0 || time_ < nextFigures_)
        return;
    metal_->requestStatistics();
    ++asked_;
    nextFigures_ = time_ + kFiguresPeriod;
}

void Trainer::takeFigures(const MetalStatistics& figures) {
    figures_ = figures;
    if (record_ && record_->waiting() > 0) guardRecord([&] { record_->complete(figures_); });
}

/// Takes answers until no more than `left` are to come.
void Trainer::awaitFigures(size_t left) {
    for (; asked_ > left; --asked_)
        takeFigures(*metal_->awaitStatistics());
}

/// A record that cannot be written on ends; the weld goes on, and whoever shows it tells of the fault.
void Trainer::guardRecord(FunctionRef<void()> write) {
    try {
        write();
    } catch (const RuntimeFault& fault) {
        recordFault_ = fault.what();
        record_ = nullptr;
    }
}

void Trainer::noteMetal() {
    const int cells = surface_->parameters.cells;
    surface_->parameters = lesson_.surface;
    surface_->parameters.cells = cells;
    metal_->prepare(*surface_);
    noted_ = metal_->particles();
    if (lesson_.look.detail == kLowDetail) noted_->frozenAt = nullptr; // ripples are not drawn
}

void Trainer::makeSurface(gl::Profiler* profiler) {
    if (noted_) surface_->update(*noted_, profiler);
    noted_.reset();
}

void Trainer::requestDistance(const TorchSample& torch) {
    if (std::exchange(forgetProbe_, false)) probe_.forget();
    probe_.request(*surface_, *metal_, torch);
}

std::optional<SurfaceDistance> Trainer::pollDistance() {
    if (std::exchange(forgetProbe_, false)) probe_.forget();
    return probe_.poll(*metal_);
}

SceneView Trainer::scene() const {
    SceneView scene = metal_->scene(torch_);
    scene.mesh = surface_->mesh();
    scene.meshIsOpen = !lesson_.surface.caps;
    scene.effects = sight_.view();
    return scene;
}

MeshCopy Trainer::bodyMesh(gl::ShaderLibrary& shaders) const {
    return meltpool::bodyMesh(shaders, *metal_, lesson_.surface);
}

RecordHead Trainer::recordHead(const RecordContext& context) {
    RecordHead head;
    head.lesson = lesson_.key;
    head.attempt = context.attempt;
    head.program = context.program;
    head.driver = context.driver;
    for (const Parameter& parameter : lesson_.metalParameters())
        head.values.emplace_back(parameter.key, parameterText(parameter));
    for (const ChosenSetting& each : lesson_.choose)
        head.chosen.push_back(each.key);
    head.arc = hasArc();
    head.rod = metal_->takesRod();
    head.paced = context.paced;
    return head;
}

void Trainer::record(const std::filesystem::path& file, const RecordContext& context) {
    awaitFigures();
    if (record_) guardRecord([&] { endRecord("another record began", metal_->stateHash()); });
    record_ = nullptr; // from here on each answer belongs to a row
    recordFault_.clear();
    record_ = std::make_unique<Record>(file, recordHead(context), context.replace);
}

RecordingHead Trainer::recordingHead() {
    RecordHead known = recordHead({});
    RecordingHead head;
    head.lesson = std::move(known.lesson);
    head.values = std::move(known.values);
    head.chosen = std::move(known.chosen);
    head.arc = known.arc;
    head.rod = known.rod;
    return head;
}

void Trainer::stopRecord(std::string_view reason) {
    awaitFigures();
    if (record_ || recording_)
        guardRecord([&] {
            const std::uint64_t hash = metal_->stateHash();
            endRecording(reason, hash); // first: a record on a full disk does not keep it from its end
            endRecord(reason, hash);
        });
    record_ = nullptr;
    recording_ = nullptr;
}

void Trainer::endRecord(std::string_view reason, std::uint64_t stateHash) {
    if (record_) record_->end(reason, stateHash);
}

void Trainer::endRecording(std::string_view reason, std::uint64_t stateHash) {
    if (!recording_) return;
    RecordingEnd end;
    end.reason = reason;
    end.stateHash = formatHexadecimal(stateHash);
    end.steps = steps_;
    end.seconds = time_;
    end.realTime = pace_.ratio();
    end.leastRealTime = pace_.least();
    recording_->end(std::move(end));
}

LessonResult Trainer::result() const {
    return {time_,         steps_, metal_->statistics(), metal_->stateHash(), metal_->bytes(), surface_->bytes(),
            metal_->wire()};
}

Judgement Trainer::judge() const {
    if (!technique_) return {};
    std::optional<FaceStretch> wanted;
    if (const auto& bands = lesson_.technique)
        wanted = FaceStretch{bands->lengthFromMm * 1e-3, bands->lengthToMm * 1e-3};
    Judgement judgement = judgeAttempt(*technique_, metal_->measureWeld(wanted),
                                       {lesson_.technique, lesson_.acceptance, lesson_.nominalWeld(), lesson_.process});
    judgement.arc = account_;
    judgement.realTime = pace_.ratio();
    return judgement;
}

std::optional<WeldSection> Trainer::section(std::optional<double> place) const {
    if (!place)
        for (const PictureLook& picture : lesson_.pictures)
            if (picture.sectionAt) place = static_cast<double>(*picture.sectionAt);
    return metal_->section(place);
}

} // namespace meltpool
