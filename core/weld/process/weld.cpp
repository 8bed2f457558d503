#include "core/weld/process/weld.hpp"

#include "core/weld/process/weld_constants.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

/// W/(m² K) from metal to a cold plate under it: 1000 to 10000 in the casting trade.
constexpr double kTableConductance = 2000;

constexpr float kGravity = 9.81F; ///< m/s²

/// m that the torch's axis may move in the steps until the probe's answer and still point at the place it found. No
/// source: chosen; 300 mm/s of hand.
constexpr float kLeavesPlace = 0.01F;

Property times(Property property, double factor) {
    for (Property::Point& point : property.points)
        point.value *= factor;
    return property;
}

/// Stirring of a pool of this metal by a process.
struct Stirring {
    double factor;  ///< times the liquid's conductivity
    bool byTension; ///< tension gives it a direction
};

Stirring stirringOf(const Material& material, const ProcessSettings& settings) {
    const HeatTable unused(material);
    const auto process = makeProcess(settings, {unused, 1, 1e-3F, 293.15});
    return {process->stirring(), process->stirredByTension() && material.boilingPoint > 0};
}

/// Returns the shares along and down for a pool of this metal under an arc.
StirringShares pulledStirringOf(const Material& material) {
    if (material.boilingPoint <= 0) return {};
    const double halfWay = std::lerp(material.liquidus, material.boilingPoint, kHalfWayToArc);
    return pulledStirring(material.tensionAt(material.liquidus) - material.tensionAt(halfWay));
}

double boilingPointOf(const Material& material) {
    return material.boilingPoint > 0 ? material.boilingPoint : std::numeric_limits<double>::infinity();
}

PhysicalSetup setupOf(const Material& material, const ProcessSettings& settings, const Workpiece& workpiece,
                      const WeldSurroundings& around) {
    const Stirring stirring = stirringOf(material, settings);
    PhysicalSetup setup;
    setup.material = material;
    setup.material.liquidConductivity = times(material.liquidConductivity, stirring.factor);
    setup.heat.directedMixing = stirring.byTension;
    setup.lattice = workpiece.lattice;
    setup.seeds = workpiece.seeds;
    setup.fillerRoom = around.fillerRoom;
    setup.space.low = workpiece.low;
    setup.space.high = workpiece.high;
    setup.marangoni = true;
    setup.gravity = glm::transpose(workpiece.turn) * glm::vec3(0, -kGravity, 0);
    setup.fragments.floorNormal = workpiece.up;
    setup.fragments.floorHeight = workpiece.floorHeight;
    setup.heat.ambient = around.ambient;
    setup.heat.ledger = around.ledger;
    setup.heat.tableNormal = workpiece.up;
    setup.heat.tableHeight = static_cast<double>(workpiece.floorHeight);
    if (around.lossless) return setup;
    setup.heat.tableConductance = kTableConductance;
    setup.heat.convection = around.convection;
    setup.heat.radiation = true;
    setup.heat.evaporation = material.boilingPoint > 0;
    return setup;
}

} // namespace

Weld::Weld(gl::ShaderLibrary& shaders, const Material& material, const Workpiece& workpiece,
           const ProcessSettings& settings, const WeldSurroundings& surroundings)
    : conductivity_(material.liquidConductivity),
      pulled_(pulledStirringOf(material)),
      metal_(shaders, setupOf(material, settings, workpiece, surroundings)),
      process_(makeProcess(settings, {metal_.table(), metal_.state().density(), workpiece.lattice.spacing,
                                      surroundings.ambient, boilingPointOf(material)})),
      stirring_(process_->stirring()),
      probe_(std::make_unique<AxisProbe>(shaders, metal_.state(), metal_.heat())) {
    if (process_->takesRod()) rodProbe_ = std::make_unique<AxisProbe>(shaders, metal_.state(), metal_.heat());
}

void Weld::reset() {
    metal_.reset();
    process_->reset();
    probe_->reset();
    if (rodProbe_) rodProbe_->reset();
}

void Weld::apply(const ProcessSettings& settings) {
    process_->apply(settings);
    if (process_->stirring() == stirring_) return;
    stirring_ = process_->stirring();
    metal_.setLiquidConductivity(times(conductivity_, stirring_));
}

void Weld::transfer(gl::StateArchive& archive) {
    const double before = stirring_;
    archive.values(stirring_);
    if (stirring_ != before) metal_.setLiquidConductivity(times(conductivity_, stirring_));
    metal_.transfer(archive);
    process_->transfer(archive);
    probe_->transfer(archive);
    if (rodProbe_) rodProbe_->transfer(archive);
}

/// Measures the distance of the found place along the axis from the torch's present position. If the torch moved
/// farther than kLeavesPlace, the place is discarded.
MetalAhead Weld::metalAhead(AxisProbe& probe, const TorchRay& ray) {
    const auto found = probe.answer();
    if (!found || !found->distance) return {};
    const glm::vec3 place = found->ray.origin + found->ray.axis * *found->distance;
    const float distance = glm::dot(place - ray.origin, ray.axis);
    if (glm::distance(place, ray.origin + ray.axis * distance) > kLeavesPlace || distance < -kLeavesPlace) return {};
    return {std::max(distance, 0.0F), found->liquid};
}

void Weld::step(const TorchSample& torch, gl::Profiler* profiler) {
    const std::optional<TorchRay> rod = process_->rodRay(torch);
    process_->step(torch, metalAhead(*probe_, process_->ray(torch)), timeStep(),
                   rod ? metalAhead(*rodProbe_, *rod) : MetalAhead{});
    metal_.setArc(process_->pressure());
    metal_.setEdgeArrest(process_->edgeArrest());
    leadStirring(process_->ray(torch).axis);
    metal_.step(process_->sources(), process_->drops(), profiler);
    lookAhead(torch, profiler);
}

/// Without an arc that heats the pool's middle nothing pulls.
void Weld::leadStirring(glm::vec3 axis) {
    if (!process_->stirredByTension()) return;
    metal_.setStirringLess(process_->arc().burns() ? stirringLess(pulled_, axis) : glm::vec3(0));
}

/// A rod that is not held is not looked for: the first answers after its return are about its old place.
void Weld::lookAhead(const TorchSample& torch, gl::Profiler* profiler) {
    const TorchRay next = process_->ray(torch);
    probe_->look({next.origin, next.axis, next.reach}, profiler);
    if (const auto rod = process_->rodRay(torch)) rodProbe_->look({rod->origin, rod->axis, rod->reach}, profiler);
}

} // namespace meltpool
