#include "core/validation/flow_rig.hpp"

#include "core/base/error.hpp"

#include <cmath>

namespace meltpool {

namespace {

constexpr double kMelting = 1000; // K: walls are colder, liquid is hotter
constexpr float kCold = 500;
constexpr float kHot = 1500;

/// Returns a table whose enthalpies only distinguish solid from liquid.
HeatTable benchTable() {
    Material plain;
    plain.solidus = plain.liquidus = kMelting;
    plain.latentHeat = 1e5;
    plain.solidConductivity = plain.liquidConductivity = Property::constant(1);
    plain.solidSpecificHeat = plain.liquidSpecificHeat = Property::constant(1000);
    return HeatTable(plain);
}

} // namespace

MetalSeed liquidSeed(glm::vec3 position) {
    return {position, kHot, PHASE_ALIVE | PHASE_LIQUID, glm::vec3(0)};
}

MetalSeed wallSeed(glm::vec3 position) {
    return {position, kCold, PHASE_ALIVE | PHASE_HELD | PHASE_CLAMPED, glm::vec3(0)};
}

void addBlock(std::vector<MetalSeed>& seeds, glm::vec3 low, glm::vec3 high, double spacing, bool isLiquid) {
    const auto dx = static_cast<float>(spacing);
    const glm::ivec3 count = glm::ivec3((high - low) / dx + 0.5F);
    for (int z = 0; z < count.z; ++z)
        for (int y = 0; y < count.y; ++y)
            for (int x = 0; x < count.x; ++x) {
                const glm::vec3 place = low + (glm::vec3(x, y, z) + 0.5F) * dx;
                seeds.push_back(isLiquid ? liquidSeed(place) : wallSeed(place));
            }
}

FlowRig::FlowRig(gl::ShaderLibrary& shaders, const FlowFluid& liquidFluid, const FlowSpace& within, glm::vec3 gravity,
                 std::span<const MetalSeed> seeds)
    : fluid(liquidFluid),
      space(within),
      // No pass of the flow reads the lattice: a single tile is enough.
      state(MetalLattice::covering(within.low, within.low, static_cast<float>(liquidFluid.spacing)), benchTable(),
            liquidFluid.density, seeds.size()),
      flow(shaders, state, liquidFluid, within) {
    for (const MetalSeed& seed : seeds)
        liquid.push_back((seed.phase & PHASE_LIQUID) != 0);
    state.setGravity(gravity);
    state.add(seeds);
}

void FlowRig::run(double seconds, double span, const std::function<void(double)>& look) {
    const auto spans = static_cast<size_t>(std::max(1.0, std::round(seconds / span)));
    const double length = seconds / static_cast<double>(spans);
    const unsigned substeps = flow.constants().substeps(length);
    for (size_t i = 0; i < spans; ++i) {
        flow.step(length, substeps, nullptr);
        time += length;
        steps += substeps;
        if (look) look(time);
    }
    const FlowFaults faults = flow.readFaults();
    if (faults.notFinite > 0) throw RuntimeFault("the flow is no longer finite");
}

std::vector<glm::dvec3> FlowRig::readPositions() const {
    const auto all = state.position.read<vec4>(liquid.size());
    std::vector<glm::dvec3> places;
    for (size_t i = 0; i < all.size(); ++i)
        if (liquid[i]) places.emplace_back(all[i]);
    return places;
}

std::vector<glm::dvec3> FlowRig::readVelocities() const {
    const auto all = state.velocity.read<vec4>(liquid.size());
    std::vector<glm::dvec3> velocities;
    for (size_t i = 0; i < all.size(); ++i)
        if (liquid[i]) velocities.emplace_back(all[i]);
    return velocities;
}

std::vector<OracleParticle> FlowRig::measure() const {
    const auto places = state.position.read<vec4>(liquid.size());
    const auto velocities = state.velocity.read<vec4>(liquid.size());
    std::vector<OracleParticle> particles(liquid.size());
    for (size_t i = 0; i < liquid.size(); ++i) {
        particles[i].position = glm::dvec3(places[i]);
        particles[i].velocity = glm::dvec3(velocities[i]);
        particles[i].liquid = liquid[i];
        particles[i].temperature = static_cast<double>(places[i].w);
    }
    const glm::dvec3 size(space.high - space.low);
    const FlowOracle gauge(fluid, glm::dvec3(0), glm::dvec3(space.repeats) * size);
    gauge.sweepDensity(particles);
    gauge.sweepForce(particles);
    return particles;
}

} // namespace meltpool
