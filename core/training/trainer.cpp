#include "core/training/trainer.hpp"

#include <utility>

namespace meltpool {

namespace {

/// Simulated time between two looks at all of the metal, s: as often as anybody can read figures. A record has the
/// newest.
constexpr double kFiguresPeriod = 0.1;

} // namespace

Trainer::Trainer(gl::ShaderLibrary& shaders, Lesson lesson)
    : lesson_(std::move(lesson)), metal_(makeMetalModel(shaders, lesson_)), probe_(shaders) {
    const SceneView scene = metal_->scene({});
    surface_ = std::make_unique<Surface>(shaders, lesson_.surface, scene.boxMin, scene.boxMax);
    torch_ = lesson_.torch.sample(0);
    torch_.trigger = 0;
    figures_ = metal_->statistics();
}

Trainer::~Trainer() = default;

void Trainer::reset() {
    stopRecord();
    metal_->reset();
    time_ = 0;
    steps_ = 0;
    asked_ = false;
    nextFigures_ = 0;
    figures_ = metal_->statistics();
    arc_ = {};
    surfaceDistance_ = {};
}

double Trainer::timeStep() const {
    return metal_->timeStep();
}

void Trainer::advance(const TorchSample& torch, gl::Profiler* profiler) {
    metal_->apply(lesson_);
    time_ += timeStep();
    torch_ = torch;
    torch_.time = time_;
    metal_->step(torch_, profiler);
    arc_ = metal_->arc(surfaceDistance_);
    ++steps_;
    updateFigures();
    if (telemetry_) telemetry_->add(torch_, figures_, hasArc() ? &arc_ : nullptr);
}

void Trainer::updateFigures() {
    if (wait_) {
        figures_ = metal_->statistics();
        return;
    }
    if (asked_) {
        if (const auto fresh = metal_->pollStatistics()) {
            figures_ = *fresh;
            asked_ = false;
        }
    }
    if (!asked_ && (telemetry_ || time_ >= nextFigures_)) {
        metal_->requestStatistics();
        nextFigures_ = time_ + kFiguresPeriod;
        asked_ = true;
    }
}

void Trainer::updateSurface(gl::Profiler* profiler) {
    const int cells = surface_->parameters.cells;
    surface_->parameters = lesson_.surface;
    surface_->parameters.cells = cells;
    metal_->prepare(*surface_);
    surface_->update(metal_->particles(), profiler);
}

SceneView Trainer::scene() const {
    SceneView scene = metal_->scene(torch_);
    scene.mesh = surface_->mesh();
    scene.meshIsOpen = !lesson_.surface.caps;
    return scene;
}

void Trainer::record(const std::filesystem::path& file) {
    stopRecord();
    telemetry_ = std::make_unique<Telemetry>(file, hasArc());
}

void Trainer::stopRecord() {
    const auto ended = std::exchange(telemetry_, nullptr);
    if (ended) ended->flush();
}

LessonResult Trainer::result() const {
    return {time_,         steps_, metal_->statistics(), metal_->stateHash(), metal_->bytes(), surface_->bytes(),
            metal_->wire()};
}

std::optional<WeldSection> Trainer::section(std::optional<double> place) const {
    if (!place)
        for (const PictureLook& picture : lesson_.pictures)
            if (picture.sectionAt) place = static_cast<double>(*picture.sectionAt);
    return metal_->section(place);
}

} // namespace meltpool
