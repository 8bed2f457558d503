// The experiments between walls: a pool at rest, a breaking dam, plates.
#include "core/validation/flow_experiments.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kFrame = 1.0 / 90;
constexpr double kWall = 3; // layers of particles, more than a support

void tellRun(FlowRun& run, const FlowRig& bench) {
    run.particles = bench.liquid.size();
    run.steps = bench.steps;
    run.faults = bench.flow.readFaults();
}

} // namespace

HydrostaticColumn hydrostaticColumn(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double height, double gravity,
                                    double seconds) {
    const double dx = fluid.spacing;
    const double wide = 8 * dx; // width after which it repeats: three supports and a little
    const double layers = std::round(height / dx);
    std::vector<MetalSeed> seeds;
    addBlock(seeds, glm::vec3(0, -kWall * dx, 0), glm::vec3(wide, 0, wide), dx, false);
    addBlock(seeds, glm::vec3(0), glm::vec3(wide, layers * dx, wide), dx, true);
    FlowSpace space{glm::vec3(0, -kWall * dx, 0), glm::vec3(wide, (layers + 6) * dx, wide)};
    space.repeats = glm::bvec3(true, false, true);
    FlowRig bench(shaders, fluid, space, glm::vec3(0, -gravity, 0), seeds);
    HydrostaticColumn result;
    // Under the surface particles are in layers, five or so, whose pressures differ by the effect of the tension.
    const double lowest = dx, highest = (layers - 5.5) * dx;
    double pressed = 0, inside = 0;
    bench.run(seconds, kFrame, [&](double time) {
        if (time < seconds * 0.8) return;
        for (const auto& particle : bench.measure()) {
            const double y = particle.position.y;
            if (!particle.liquid || y < lowest) continue;
            if (y < highest) {
                result.bottomPressure += particle.pressure + fluid.density * gravity * y;
                pressed += 1;
            }
            if (y < (layers - 3) * dx) {
                result.densityError += std::abs(particle.delta / bench.flow.constants().scale / 1.0064 - 1);
                inside += 1;
            }
        }
    });
    result.bottomPressure /= pressed;
    result.densityError /= inside;
    double sum = 0;
    const auto velocities = bench.readVelocities();
    for (const auto& velocity : velocities)
        sum += glm::dot(velocity, velocity);
    result.restSpeed = std::sqrt(sum / static_cast<double>(velocities.size()));
    tellRun(result, bench);
    return result;
}

DamBreak damBreak(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double width, double gravity,
                  std::span<const double> times) {
    const double dx = fluid.spacing;
    const double columns = std::round(width / dx);
    const double deep = 8 * dx;
    const double length = std::ceil(15 * columns) * dx;
    std::vector<MetalSeed> seeds;
    addBlock(seeds, glm::vec3(-kWall * dx, -kWall * dx, 0), glm::vec3(length, 0, deep), dx, false);
    addBlock(seeds, glm::vec3(-kWall * dx, 0, 0), glm::vec3(0, (2 * columns + 6) * dx, deep), dx, false);
    addBlock(seeds, glm::vec3(0), glm::vec3(columns * dx, 2 * columns * dx, deep), dx, true);
    FlowSpace space{glm::vec3(-kWall * dx, -kWall * dx, 0), glm::vec3(length, (2 * columns + 6) * dx, deep)};
    space.repeats = glm::bvec3(false, false, true);
    FlowRig bench(shaders, fluid, space, glm::vec3(0, -gravity, 0), seeds);
    DamBreak result;
    for (const double time : times) {
        bench.run(time - bench.time, kFrame);
        std::vector<double> fronts;
        for (const auto& place : bench.readPositions())
            fronts.push_back(place.x);
        // The front is the arrival of a row of particles across the channel, not its fastest splash.
        std::nth_element(fronts.begin(), fronts.begin() + 7, fronts.end(), std::greater<>());
        result.fronts.push_back(fronts[7] + dx / 2);
    }
    tellRun(result, bench);
    return result;
}

PlateFlow plateFlow(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double gap, double bodyForce, double seconds) {
    const double dx = fluid.spacing;
    const double wide = 8 * dx;
    const double layers = std::round(gap / dx);
    std::vector<MetalSeed> seeds;
    addBlock(seeds, glm::vec3(0, -kWall * dx, 0), glm::vec3(wide, 0, wide), dx, false);
    addBlock(seeds, glm::vec3(0), glm::vec3(wide, layers * dx, wide), dx, true);
    addBlock(seeds, glm::vec3(0, layers * dx, 0), glm::vec3(wide, (layers + kWall) * dx, wide), dx, false);
    FlowSpace space{glm::vec3(0, -kWall * dx, 0), glm::vec3(wide, (layers + kWall) * dx, wide)};
    space.repeats = glm::bvec3(true, false, true);
    space.acceleration = glm::vec3(bodyForce / fluid.density, 0, 0);
    FlowRig bench(shaders, fluid, space, glm::vec3(0), seeds);
    bench.run(seconds, kFrame);
    PlateFlow result;
    const auto places = bench.readPositions();
    const auto velocities = bench.readVelocities();
    for (size_t i = 0; i < places.size(); ++i) {
        result.places.push_back(places[i].y);
        result.velocities.push_back(velocities[i].x);
    }
    tellRun(result, bench);
    return result;
}

} // namespace meltpool
