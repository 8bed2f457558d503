#include "core/scene/weld_scene.hpp"

#include "core/scene/torch_fittings.hpp"
#include "core/scene/torch_model.hpp"
#include "core/scene/workshop_furniture.hpp"
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
/// Radius of an island of oxide on a pool, in spacings. No source: chosen; on plates of 1 mm spacing islands are 2 mm
/// wide.
constexpr float kOxideRadius = 1.1F;

/// Returns the upper end of the temperature colours, K: the melt's share of the scale is a third for solder and steel
/// alike.
float colourTop(const Material& material) {
    const auto liquidus = static_cast<float>(material.liquidus);
    return liquidus + std::max(0.5F * (liquidus - kRoomTemperature), 50.0F);
}

} // namespace

WeldScene::WeldScene(const ShownWeld& shown)
    : shown_(shown),
      rolled_(rolledFaces(shown.parameters, shown.workpiece)),
      overTable_(fixtureOf(shown.parameters).overTable) {
    furnish();
}

/// Drops come to rest on the table, or as far below as the workpiece is held over it.
void WeldScene::furnish() {
    const Workpiece& workpiece = shown_.workpiece;
    const glm::mat4 toWorld = glm::scale(glm::mat4(1.0F), glm::vec3(1 / kWorldUnit));
    const float top = workpiece.floorHeight - overTable_;
    const glm::mat4 benchToWorld = glm::translate(toWorld, {0, top, 0});
    roomToWorld_ = glm::translate(toWorld, {0, top - kUsualTableHeight - float(WORKSHOP_FLOOR), 0});
    furniture_.clear();
    furniture_.reserve(kMostFurniture); // reserved, so that solids that a view() lent do not move
    displays_ = equipmentOf(shown_.process).displays;
    units_ = chosenUnits();
    addTable(furniture_, benchToWorld, kUsualTableHeight);
    addMachine(furniture_, benchToWorld, shown_.process);
    const size_t others = furniture_.size();
    meltpool::addHolders(furniture_, toWorld, workpiece, overTable_);
    holders_ = furniture_.size() - others;
    cableEnd_ = glm::transpose(workpiece.turn) * (kCableEnd + glm::vec3(0, top, 0));
}

void WeldScene::addHolders(std::vector<Solid>& solids, float overTable) const {
    meltpool::addHolders(solids, glm::scale(glm::mat4(1.0F), glm::vec3(1 / kWorldUnit)), shown_.workpiece, overTable);
}

void WeldScene::showTorch(SceneView& scene, const TorchSample& torch) {
    const ArcState& arc = shown_.weld.arc();
    scene.rodSolids = buildTorchModel(torchSolids_, torch, shown_.process, arc, scene.modelToWorld);
    scene.arc = torchArcLight(torch, shown_.process, arc);
    scene.solids = torchSolids_;
    TorchSurroundings around;
    around.cableEnd = cableEnd_;
    around.up = shown_.workpiece.up;
    buildTorchFittings(fittings_, torch, shown_.process, around, scene.modelToWorld);
    scene.fittings = fittings_;
}

SceneView WeldScene::view(const TorchSample& torch) {
    const Equipment equipment = equipmentOf(shown_.process);
    if (equipment.displays != displays_ || units_ != chosenUnits()) furnish();
    const Workpiece& workpiece = shown_.workpiece;
    const Material& material = shown_.material;
    SceneView scene;
    scene.modelToWorld = glm::scale(glm::mat4(1.0F), glm::vec3(1 / kWorldUnit)) * glm::mat4(workpiece.turn);
    scene.boxMin = workpiece.low;
    scene.boxMax = workpiece.high;
    scene.cubeWidth = kWorldUnit;
    showTorch(scene, torch);
    scene.room = {true, roomToWorld_};
    scene.furniture = furniture_;
    scene.holderSolids = holders_;
    scene.tableShown = overTable_ == 0;
    scene.tableTop = (workpiece.floorHeight - overTable_) / kWorldUnit;
    scene.blocks = workpiece.blocks;
    scene.temperature = {kRoomTemperature, colourTop(material), true, static_cast<float>(material.solidus),
                         static_cast<float>(material.liquidus)};
    scene.looks = &material.looks;
    scene.ripples = equipment.ripples;
    scene.rolled = rolled_;
    if (traitsOf(shown_.process).oxideIslands && material.looks.millScale > 0)
        scene.oxideRadius = kOxideRadius * workpiece.lattice.spacing;
    return scene;
}

} // namespace meltpool
