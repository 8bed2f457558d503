#include "core/training/trainer/weld_model.hpp"

#include "core/scene/weld_scene.hpp"
#include "core/surface/surface_level.hpp"
#include "core/training/lesson/lesson.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr float kRoomTemperature = 293.15F;

std::optional<double> pipeRadiusOf(const WorkpieceParameters& workpiece) {
    if (static_cast<WorkpieceKind>(workpiece.kind) != WorkpieceKind::Pipe) return std::nullopt;
    return static_cast<double>(workpiece.diameterMm) * 0.5e-3;
}

} // namespace

WeldModel::WeldModel(gl::ShaderLibrary& shaders, const Lesson& lesson)
    : material_(workpieceMaterial(lesson.workpiece)),
      parameters_(lesson.workpiece),
      workpiece_(makeWorkpiece(parameters_)),
      kind_(weldKindOf(parameters_)),
      pipeRadius_(pipeRadiusOf(parameters_)),
      process_(lesson.process),
      weld_(shaders, material_, workpiece_, process_) {}

void WeldModel::reset() {
    weld_.reset();
}

void WeldModel::apply(const Lesson& lesson) {
    const int kind = process_.kind;
    process_ = lesson.process;
    process_.kind = kind; // another process waits for the next start
    weld_.apply(process_);
}

void WeldModel::step(const TorchSample& torch, gl::Profiler* profiler) {
    weld_.step(torch, profiler);
}

std::optional<WeldSection> WeldModel::section(std::optional<double> place) const {
    if (pipeRadius_) return std::nullopt;
    SectionCut cut = sectionCut(material_, 0, 0);
    const double at = place ? *place : middleOfWeld(weld_.metal().state(), workpiece_.parts(), cut.fusion);
    cut.from = at - kSectionLength / 2;
    cut.to = at + kSectionLength / 2;
    return cutWeld(weld_.metal().state(), workpiece_.parts(), cut);
}

std::optional<WeldMeasures> WeldModel::measureWeld(const StationSettings& stations) const {
    if (pipeRadius_)
        return meltpool::measureWeld(WeldParticles(weld_.metal().state(), workpiece_.parts(), *pipeRadius_), material_,
                                     kind_, stations);
    return meltpool::measureWeld(weld_.metal().state(), workpiece_.parts(), material_, kind_, stations);
}

std::unique_ptr<MetalScene> WeldModel::makeScene() const {
    return std::make_unique<WeldScene>(ShownWeld{weld_, workpiece_, parameters_, material_, process_});
}

float WeldModel::liquidShare(float temperature) const {
    const auto solidus = static_cast<float>(material_.solidus);
    const auto range = static_cast<float>(material_.liquidus) - solidus;
    if (range <= 0) return temperature > solidus ? 1.0F : 0.0F;
    return std::clamp((temperature - solidus) / range, 0.0F, 1.0F);
}

void WeldModel::prepare(Surface& surface) const {
    surface.setTemperatureRange(kRoomTemperature, 3500);
    surface.parameters.isoLevel *= flatFaceLevel(surface.parameters, surface.grid(), workpiece_.lattice.spacing);
    surface.flatFaces.count = 0;
    for (const WorkpieceBlock& block : workpiece_.blocks)
        for (const glm::vec3& corner : {block.low, block.high})
            if (surface.flatFaces.count < SURFACE_FLAT_PLANES)
                surface.flatFaces.corners[size_t(surface.flatFaces.count++)] = corner;
    surface.roundFaces = {};
    if (const auto& pipe = workpiece_.pipe)
        surface.roundFaces = {pipe->axis, pipe->low, pipe->high, pipe->outer, pipe->inner};
    // Particles keep their slots; less than a fiftieth of a cell or 3 K is invisible.
    surface.incremental = {true, 0.02F, 0.001F};
}

} // namespace meltpool
