#include "core/training/weld_model.hpp"

#include "core/training/lesson.hpp"

#include <glm/ext/matrix_transform.hpp>

#include <cmath>

namespace meltpool {

namespace {

/// World units of the pictures in metres, as for the classic cube, so that cameras of all lessons are alike.
constexpr float kWorldUnit = 0.04F;
constexpr float kRoomTemperature = 293.15F;
constexpr float kColourTop = 2500; ///< K, upper end of the temperature colours

PhysicalSetup setupOf(const Material& material, const Workpiece& workpiece) {
    PhysicalSetup setup;
    setup.material = material;
    setup.lattice = workpiece.lattice;
    setup.seeds = workpiece.seeds;
    setup.space.low = workpiece.low;
    setup.space.high = workpiece.high;
    setup.pieces.floorHeight = workpiece.floorHeight;
    setup.heat.ambient = static_cast<double>(kRoomTemperature);
    setup.heat.convection = 15; // still air over hot plate, W/(m² K)
    setup.heat.radiation = true;
    setup.heat.evaporation = material.boilingPoint > 0;
    return setup;
}

} // namespace

float flatFaceLevel(float spacing, float cell, int influence) {
    const float reach = std::sqrt(3.0F) / 2 + std::sqrt(3.0F) * static_cast<float>(influence - 1);
    constexpr int kSamples = 8; // places of a particle within its nearest corner's cell, per axis
    double sum = 0;
    for (int s = 0; s < kSamples * kSamples * kSamples; ++s) {
        const glm::vec3 place = (glm::vec3(s % kSamples, s / kSamples % kSamples, s / (kSamples * kSamples)) + 0.5F) /
                                    static_cast<float>(kSamples) -
                                0.5F;
        for (int z = 1 - influence; z < influence; ++z)
            for (int y = 1 - influence; y < influence; ++y)
                for (int x = 1 - influence; x < influence; ++x)
                    sum += static_cast<double>(std::max(0.0F, 1 - glm::length(glm::vec3(x, y, z) - place) / reach));
    }
    const double perParticle = sum / (kSamples * kSamples * kSamples);
    return static_cast<float>(0.5 * perParticle * std::pow(static_cast<double>(cell / spacing), 3));
}

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
    const std::vector<MetalSeed> filler = process_.feed(torch, timeStep());
    metal_.step(process_.sources(torch), filler, profiler);
}

SceneView WeldModel::scene(const TorchSample& torch) const {
    SceneView scene;
    scene.particles = metal_.particles();
    scene.modelToWorld = glm::scale(glm::mat4(1.0F), glm::vec3(1 / kWorldUnit));
    scene.boxMin = workpiece_.low;
    scene.boxMax = workpiece_.high;
    scene.cubeWidth = kWorldUnit;
    scene.source.shown = true;
    scene.source.position = torch.tip;
    scene.source.size = 0.002F;
    scene.source.on = torch.trigger > 0;
    scene.temperature = {kRoomTemperature, kColourTop, true, static_cast<float>(material_.solidus),
                         static_cast<float>(material_.liquidus)};
    scene.looks = &material_.looks;
    return scene;
}

void WeldModel::prepare(Surface& surface) const {
    surface.setTemperatureRange(kRoomTemperature, 3500);
    const SurfaceGrid& grid = surface.grid();
    const float cell = (grid.boxMax.x - grid.boxMin.x) / static_cast<float>(grid.cells.x);
    surface.parameters.isoLevel *= flatFaceLevel(workpiece_.lattice.spacing, cell, surface.parameters.influence);
}

} // namespace meltpool
