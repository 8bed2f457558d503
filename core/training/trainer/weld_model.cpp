#include "core/training/trainer/weld_model.hpp"

#include "core/scene/bench_things.hpp"
#include "core/scene/torch_fittings.hpp"
#include "core/scene/torch_model.hpp"
#include "core/surface/surface_level.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/weld/workpiece/position.hpp"
#include "shaders/shared/render.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace meltpool {

namespace {

/// World units of the pictures in metres, as for the classic cube, so that cameras of all lessons are alike.
constexpr float kWorldUnit = 0.04F;
constexpr size_t kMostFurniture = 512;
constexpr float kRoomTemperature = 293.15F;
/// Of an island of oxide on a pool, in spacings. None: chosen; on plates of 1 mm spacing islands are 2 mm wide.
constexpr float kOxideRadius = 1.1F;

/// Upper end of the temperature colours, K: the melt's share of the scale is a third for solder and steel alike.
float colourTop(const Material& material) {
    const auto liquidus = static_cast<float>(material.liquidus);
    return liquidus + std::max(0.5F * (liquidus - kRoomTemperature), 50.0F);
}

std::optional<double> pipeRadiusOf(const WorkpieceParameters& workpiece) {
    if (static_cast<WorkpieceKind>(workpiece.kind) != WorkpieceKind::Pipe) return std::nullopt;
    return static_cast<double>(workpiece.diameterMm) * 0.5e-3;
}

} // namespace

WeldModel::WeldModel(gl::ShaderLibrary& shaders, const Lesson& lesson)
    : material_(workpieceMaterial(lesson.workpiece)),
      workpiece_(makeWorkpiece(lesson.workpiece)),
      rolled_(rolledFaces(lesson.workpiece, workpiece_)),
      kind_(weldKindOf(lesson.workpiece)),
      pipeRadius_(pipeRadiusOf(lesson.workpiece)),
      process_(lesson.process),
      weld_(shaders, material_, workpiece_, lesson.process),
      overTable_(fixtureOf(lesson.workpiece).overTable) {
    furnish();
}

/// The table is where drops come to rest, or as far below as the workpiece is held over it.
void WeldModel::furnish() {
    const glm::mat4 toWorld = glm::scale(glm::mat4(1.0F), glm::vec3(1 / kWorldUnit));
    const float top = workpiece_.floorHeight - overTable_;
    const glm::mat4 benchToWorld = glm::translate(toWorld, {0, top, 0});
    roomToWorld_ = glm::translate(toWorld, {0, top - kUsualTableHeight - float(WORKSHOP_FLOOR), 0});
    furniture_.clear();
    furniture_.reserve(kMostFurniture); // what a scene() lent stays in its place
    addTable(furniture_, benchToWorld, kUsualTableHeight);
    addMachine(furniture_, benchToWorld, process_);
    const size_t others = furniture_.size();
    addHolders(furniture_, toWorld, workpiece_, overTable_);
    holders_ = furniture_.size() - others;
    cableEnd_ = glm::transpose(workpiece_.turn) * (kCableEnd + glm::vec3(0, top, 0));
}

void WeldModel::reset() {
    weld_.reset();
}

void WeldModel::apply(const Lesson& lesson) {
    const int kind = process_.kind;
    const auto shown = equipmentOf(process_).displays;
    process_ = lesson.process;
    process_.kind = kind; // another process waits for the next start
    if (equipmentOf(process_).displays != shown) furnish();
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

std::optional<WeldMeasures> WeldModel::measureWeld(std::optional<FaceStretch> seam) const {
    StationSettings settings;
    settings.seam = seam;
    if (pipeRadius_)
        return meltpool::measureWeld(WeldParticles(weld_.metal().state(), workpiece_.parts(), *pipeRadius_), material_,
                                     kind_, settings);
    return meltpool::measureWeld(weld_.metal().state(), workpiece_.parts(), material_, kind_, settings);
}

SceneView WeldModel::scene(const TorchSample& torch) const {
    SceneView scene;
    scene.particles = weld_.metal().particles();
    scene.modelToWorld = glm::scale(glm::mat4(1.0F), glm::vec3(1 / kWorldUnit)) * glm::mat4(workpiece_.turn);
    scene.boxMin = workpiece_.low;
    scene.boxMax = workpiece_.high;
    scene.cubeWidth = kWorldUnit;
    scene.rodSolids = buildTorchModel(torchSolids_, torch, process_, weld_.arc(), scene.modelToWorld);
    scene.arc = torchArcLight(torch, process_, weld_.arc());
    scene.solids = torchSolids_;
    TorchSurroundings around;
    around.cableEnd = cableEnd_;
    around.up = workpiece_.up;
    buildTorchFittings(fittings_, torch, process_, around, scene.modelToWorld);
    scene.fittings = fittings_;
    scene.room = {true, roomToWorld_};
    scene.furniture = furniture_;
    scene.holderSolids = holders_;
    scene.tableShown = overTable_ == 0;
    scene.tableTop = (workpiece_.floorHeight - overTable_) / kWorldUnit;
    scene.blocks = workpiece_.blocks;
    scene.temperature = {kRoomTemperature, colourTop(material_), true, static_cast<float>(material_.solidus),
                         static_cast<float>(material_.liquidus)};
    scene.looks = &material_.looks;
    scene.ripples = equipmentOf(process_).ripples;
    scene.rolled = rolled_;
    if (traitsOf(process_).oxideIslands && material_.looks.millScale > 0)
        scene.oxideRadius = kOxideRadius * workpiece_.lattice.spacing;
    return scene;
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
    // Particles keep their slots; less than a fiftieth of a cell or 3 K is seen by nobody.
    surface.incremental = {true, 0.02F, 0.001F};
}

} // namespace meltpool
