#include "core/training/weld_model.hpp"

#include "core/render/torch_model.hpp"
#include "core/surface/surface_level.hpp"
#include "core/training/lesson.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>

namespace meltpool {

namespace {

/// World units of the pictures in metres, as for the classic cube, so that cameras of all lessons are alike.
constexpr float kWorldUnit = 0.04F;
constexpr float kRoomTemperature = 293.15F;

PhysicalSetup setupOf(const Material& material, const Workpiece& workpiece) {
    PhysicalSetup setup;
    setup.material = material;
    setup.lattice = workpiece.lattice;
    setup.seeds = workpiece.seeds;
    setup.space.low = workpiece.low;
    setup.space.high = workpiece.high;
    setup.fragments.floorHeight = workpiece.floorHeight;
    setup.heat.ambient = static_cast<double>(kRoomTemperature);
    setup.heat.tableHeight = static_cast<double>(workpiece.floorHeight);
    setup.heat.tableConductance = 2000; // liquid metal on a cold plate: 1000 to 10000 in the casting trade
    setup.heat.convection = 15;         // still air over hot plate, W/(m² K)
    setup.heat.radiation = true;
    setup.heat.evaporation = material.boilingPoint > 0;
    return setup;
}

/// Upper end of the temperature colours, K: the melt's share of the scale is a third for solder and steel alike.
float colourTop(const Material& material) {
    const auto liquidus = static_cast<float>(material.liquidus);
    return liquidus + std::max(0.5F * (liquidus - kRoomTemperature), 50.0F);
}

} // namespace

WeldModel::WeldModel(gl::ShaderLibrary& shaders, const Lesson& lesson)
    : material_(workpieceMaterial(lesson.workpiece)),
      workpiece_(makeWorkpiece(lesson.workpiece)),
      metal_(shaders, setupOf(material_, workpiece_)),
      process_(metal_.table(), metal_.state().density(), workpiece_.lattice.spacing, kRoomTemperature) {
    apply(lesson);
}

void WeldModel::reset() {
    metal_.reset();
    process_.reset();
}

void WeldModel::apply(const Lesson& lesson) {
    process_.parameters = lesson.process;
}

void WeldModel::step(const TorchSample& torch, gl::Profiler* profiler) {
    const std::span<const MetalSeed> filler = process_.feed(torch, timeStep());
    metal_.setArc(process_.pressure(torch));
    metal_.step(process_.sources(torch), filler, profiler);
}

std::optional<WeldSection> WeldModel::section(std::optional<double> place) const {
    SectionCut cut = sectionCut(material_, 0, 0);
    const double at = place ? *place : middleOfWeld(metal_.state(), workpiece_.seeds, cut.fusion);
    cut.from = at - kSectionLength / 2;
    cut.to = at + kSectionLength / 2;
    return cutWeld(metal_.state(), workpiece_.seeds, cut);
}

SceneView WeldModel::scene(const TorchSample& torch) const {
    SceneView scene;
    scene.particles = metal_.particles();
    scene.modelToWorld = glm::scale(glm::mat4(1.0F), glm::vec3(1 / kWorldUnit));
    scene.boxMin = workpiece_.low;
    scene.boxMax = workpiece_.high;
    scene.cubeWidth = kWorldUnit;
    buildTorchModel(torchSolids_, torch, process_.parameters, scene.modelToWorld);
    scene.arc = torchArcLight(torch, process_.parameters);
    scene.solids = torchSolids_;
    scene.temperature = {kRoomTemperature, colourTop(material_), true, static_cast<float>(material_.solidus),
                         static_cast<float>(material_.liquidus)};
    scene.looks = &material_.looks;
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
    // Particles keep their slots; less than a fiftieth of a cell or 3 K is seen by nobody.
    surface.incremental = {true, 0.02F, 0.001F};
}

} // namespace meltpool
