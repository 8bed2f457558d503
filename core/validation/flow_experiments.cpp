#include "core/validation/flow_experiments.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr double kFrame = 1.0 / 90;

void tellRun(FlowRun& run, const FlowRig& bench) {
    run.particles = bench.liquid.size();
    run.steps = bench.steps;
    run.faults = bench.flow.readFaults();
}

double rmsSpeed(const FlowRig& bench) {
    double sum = 0;
    const auto velocities = bench.readVelocities();
    for (const glm::dvec3& velocity : velocities)
        sum += glm::dot(velocity, velocity);
    return std::sqrt(sum / static_cast<double>(velocities.size()));
}

/// Returns the points of a lattice within the sphere around 0, the lattice moved by `shift` spacings along each axis.
std::vector<MetalSeed> sphere(const FlowFluid& fluid, double radius, double shift = 0) {
    std::vector<MetalSeed> all, seeds;
    const auto reach = static_cast<float>((std::ceil(radius / fluid.spacing) + 1) * fluid.spacing);
    addBlock(all, glm::vec3(-reach), glm::vec3(reach), fluid.spacing, true);
    for (MetalSeed& seed : all) {
        seed.position += static_cast<float>(shift * fluid.spacing);
        if (glm::length(glm::dvec3(seed.position)) < radius) seeds.push_back(seed);
    }
    return seeds;
}

/// Returns the radius (m) of the ball that has the volume of `particles`: a lattice's points in a ball are some more or
/// fewer than it holds.
double radiusOf(const FlowFluid& fluid, size_t particles) {
    return fluid.spacing * std::cbrt(3 * static_cast<double>(particles) / (4 * std::numbers::pi));
}

/// Lattices that drops start from. The order in which particles come to rest depends on them, and the pressure with it
/// by a tenth, the frequency by a twentieth.
constexpr std::array kShifts{0.0, 0.2, 0.35};
constexpr double kShare = 1.0 / kShifts.size();

void addRun(FlowRun& sum, const FlowRun& run) {
    sum.particles = run.particles;
    sum.steps += run.steps;
    sum.faults.cellsOverfull += run.faults.cellsOverfull;
    sum.faults.neighboursOverfull += run.faults.neighboursOverfull;
    sum.faults.listsOverfull += run.faults.listsOverfull;
}

FlowSpace spaceAround(double radius) {
    const auto reach = static_cast<float>(2 * radius);
    return {glm::vec3(-reach), glm::vec3(reach)};
}

/// Returns the second moment along an axis less the mean of the other two: 0 for a sphere.
double elongation(const std::vector<glm::dvec3>& places, int axis) {
    glm::dvec3 mean(0), square(0);
    for (const glm::dvec3& place : places)
        mean += place / static_cast<double>(places.size());
    for (const glm::dvec3& place : places)
        square += (place - mean) * (place - mean) / static_cast<double>(places.size());
    return 1.5 * square[axis] - 0.5 * (square.x + square.y + square.z);
}

DropletPressure pressureOf(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double radius, double seconds,
                           std::span<const MetalSeed> seeds) {
    FlowRig bench(shaders, fluid, spaceAround(radius), glm::vec3(0), seeds);
    DropletPressure result;
    // The inner part is beyond the surface's own layer, in which tension pulls; at least half the radius.
    const double inner = std::max(radius / 2, radius - bench.flow.constants().support);
    double samples = 0;
    bench.run(seconds, kFrame, [&](double time) {
        if (time < seconds * 2 / 3) return;
        const auto particles = bench.measure();
        glm::dvec3 centre(0);
        for (const auto& particle : particles)
            centre += particle.position / static_cast<double>(particles.size());
        double pressure = 0, density = 0, inside = 0;
        for (const auto& particle : particles) {
            if (glm::length(particle.position - centre) > inner) continue;
            pressure += particle.pressure;
            density += particle.delta;
            inside += 1;
        }
        result.jump += pressure / inside;
        result.density += density / inside / bench.flow.constants().scale / 1.0064;
        samples += 1;
    });
    result.jump *= radiusOf(fluid, seeds.size()) / radius / samples;
    result.density /= samples;
    result.restSpeed = rmsSpeed(bench);
    tellRun(result, bench);
    return result;
}

/// Measures an oscillation. `seeds`: the drop, whose frequency is scaled to that of a drop of `radius`.
DropletOscillation oscillationOf(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double radius, double seconds,
                                 std::span<const MetalSeed> seeds) {
    const double expected =
        std::sqrt(8 * fluid.tension / (fluid.density * radius * radius * radius)) / (2 * std::numbers::pi);
    // All times are in periods and in the longest steps, so that drops of one shape behave alike in any material.
    constexpr double kRest = 8, kWatchedAtLeast = 3; // periods
    const double step = 0.999 * FlowConstants::of(fluid).longestStep;
    const double interval = step * std::max(1.0, std::round(1 / (30 * expected * step))); // some 30 samples a period
    const double restTime = interval * std::ceil(kRest / (expected * interval));
    const double watched = interval * std::ceil(std::max(seconds, kWatchedAtLeast / expected) / interval);
    FlowRig rest(shaders, fluid, spaceAround(radius), glm::vec3(0), seeds);
    rest.run(restTime, interval);
    DropletOscillation result;
    // The particles of a drop have some order, which makes it stiffer along one axis than along another.
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 stretch(1 / std::sqrt(1.1));
        stretch[axis] = 1.1;
        std::vector<MetalSeed> stretched;
        for (const glm::dvec3& place : rest.readPositions())
            stretched.push_back(liquidSeed(glm::vec3(place * stretch)));
        FlowRig bench(shaders, fluid, spaceAround(radius), glm::vec3(0), stretched);
        std::vector<double> samples{elongation(bench.readPositions(), axis)};
        bench.run(watched, interval, [&](double) { samples.push_back(elongation(bench.readPositions(), axis)); });
        const DampedFit fit = fitDamped(samples, interval, 0.5 * expected, 1.5 * expected);
        result.frequency += fit.frequency / 3;
        result.decay += fit.decay / 3;
        if (axis == 2) tellRun(result, bench);
    }
    result.frequency *= std::pow(radiusOf(fluid, seeds.size()) / radius, 1.5);
    return result;
}

} // namespace

DropletPressure dropletPressure(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double radius, double seconds) {
    DropletPressure result;
    for (const double shift : kShifts) {
        const DropletPressure one = pressureOf(shaders, fluid, radius, seconds, sphere(fluid, radius, shift));
        result.jump += kShare * one.jump;
        result.density += kShare * one.density;
        result.restSpeed += kShare * one.restSpeed;
        addRun(result, one);
    }
    return result;
}

DropletOscillation dropletOscillation(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double radius,
                                      double seconds) {
    DropletOscillation result;
    for (const double shift : kShifts) {
        const DropletOscillation one = oscillationOf(shaders, fluid, radius, seconds, sphere(fluid, radius, shift));
        result.frequency += kShare * one.frequency;
        result.decay += kShare * one.decay;
        addRun(result, one);
    }
    return result;
}

SessileDrop sessileDrop(gl::ShaderLibrary& shaders, const FlowFluid& fluid, double volume, double gravity,
                        double seconds) {
    const double dx = fluid.spacing;
    // The block has as many particles as the volume holds; the remainder is in the middle of one more layer.
    const auto whole = static_cast<size_t>(std::round(volume / (dx * dx * dx)));
    const double side = std::round(std::cbrt(2 * volume) / dx);
    const double layers = std::max(1.0, std::ceil(static_cast<double>(whole) / (side * side)));
    const double edge = std::ceil(1.7 * std::cbrt(volume) / dx + 0.5 * side) * dx; // half the wall
    const auto half = static_cast<float>(0.5 * side * dx);
    std::vector<MetalSeed> drop;
    addBlock(drop, glm::vec3(-half, 0, -half), glm::vec3(half, layers * dx, half), dx, true);
    const auto order = [dx](const MetalSeed& seed) {
        const glm::vec3 p = seed.position;
        return std::pair(std::floor(static_cast<double>(p.y) / dx), p.x * p.x + p.z * p.z);
    };
    std::stable_sort(drop.begin(), drop.end(),
                     [&](const MetalSeed& a, const MetalSeed& b) { return order(a) < order(b); });
    drop.resize(std::min(drop.size(), whole));
    std::vector<MetalSeed> seeds;
    addBlock(seeds, glm::vec3(-edge, -3 * dx, -edge), glm::vec3(edge, 0, edge), dx, false);
    seeds.insert(seeds.end(), drop.begin(), drop.end());
    const FlowSpace space{glm::vec3(-edge, -3 * dx, -edge), glm::vec3(edge, 2 * layers * dx + 4 * dx, edge)};
    FlowRig bench(shaders, fluid, space, glm::vec3(0, -gravity, 0), seeds);
    SessileDrop result;
    double samples = 0;
    bench.run(seconds, kFrame, [&](double time) {
        if (time < seconds * 0.8) return;
        result.height += apexHeight(bench.readPositions(), dx);
        samples += 1;
    });
    result.height /= samples;
    result.restSpeed = rmsSpeed(bench);
    tellRun(result, bench);
    return result;
}

double apexHeight(std::span<const glm::dvec3> places, double spacing) {
    constexpr double kReach = 2.5;                // spacings from the axis
    constexpr double kAbove = 0.3, kBeside = 0.7; // spacings: a particle this much higher and this near covers another
    glm::dvec3 centre(0);
    for (const glm::dvec3& place : places)
        centre += place / static_cast<double>(places.size());
    const auto way = [](const glm::dvec3& a, const glm::dvec3& b) { return std::hypot(a.x - b.x, a.z - b.z); };
    const auto covered = [&](const glm::dvec3& place) {
        return std::any_of(places.begin(), places.end(), [&](const glm::dvec3& other) {
            return other.y > place.y + kAbove * spacing && way(other, place) < kBeside * spacing;
        });
    };
    // A ball around (0, middle): r² + y² = 2 middle y + rest, by least squares.
    double count = 0, sumY = 0, sumYY = 0, sumS = 0, sumSY = 0;
    for (const glm::dvec3& place : places) {
        const double r = way(place, centre);
        if (r > kReach * spacing || covered(place)) continue;
        const double square = r * r + place.y * place.y;
        count += 1;
        sumY += place.y;
        sumYY += place.y * place.y;
        sumS += square;
        sumSY += square * place.y;
    }
    const double middle = 0.5 * (count * sumSY - sumS * sumY) / (count * sumYY - sumY * sumY);
    const double rest = (sumS - 2 * middle * sumY) / count;
    return middle + std::sqrt(rest + middle * middle) + spacing / 2;
}

DampedFit fitDamped(std::span<const double> samples, double interval, double lowestFrequency, double highestFrequency) {
    // The rest is linear for a given frequency and decay: solve three normal equations, and search the two on a grid
    // that closes in on the best.
    const auto residual = [&](double frequency, double decay) {
        double a[3][4] = {};
        for (size_t i = 0; i < samples.size(); ++i) {
            const double t = static_cast<double>(i) * interval;
            const double phase = 2 * std::numbers::pi * frequency * t;
            const double basis[4] = {std::exp(-decay * t) * std::cos(phase), std::exp(-decay * t) * std::sin(phase), 1,
                                     samples[i]};
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 4; ++column)
                    a[row][column] += basis[row] * basis[column];
        }
        double x[3] = {};
        for (int pivot = 0; pivot < 3; ++pivot)
            for (int row = pivot + 1; row < 3; ++row) {
                const double factor = a[row][pivot] / a[pivot][pivot];
                for (int column = pivot; column < 4; ++column)
                    a[row][column] -= factor * a[pivot][column];
            }
        for (int row = 2; row >= 0; --row) {
            x[row] = a[row][3];
            for (int column = row + 1; column < 3; ++column)
                x[row] -= a[row][column] * x[column];
            x[row] /= a[row][row];
        }
        double sum = 0;
        for (size_t i = 0; i < samples.size(); ++i) {
            const double t = static_cast<double>(i) * interval;
            const double phase = 2 * std::numbers::pi * frequency * t;
            const double value =
                std::exp(-decay * t) * (x[0] * std::cos(phase) + x[1] * std::sin(phase)) + x[2] - samples[i];
            sum += value * value;
        }
        return sum;
    };
    double lowF = lowestFrequency, highF = highestFrequency;
    double lowD = 0, highD = 2 * highestFrequency;
    DampedFit best;
    for (int round = 0; round < 8; ++round) {
        constexpr int kSteps = 20;
        double least = -1;
        for (int i = 0; i <= kSteps; ++i)
            for (int j = 0; j <= kSteps; ++j) {
                const double frequency = lowF + (highF - lowF) * i / kSteps;
                const double decay = lowD + (highD - lowD) * j / kSteps;
                const double sum = residual(frequency, decay);
                if (least >= 0 && sum >= least) continue;
                least = sum;
                best = {frequency, decay};
            }
        const double widthF = (highF - lowF) / kSteps * 2, widthD = (highD - lowD) / kSteps * 2;
        lowF = std::max(lowestFrequency, best.frequency - widthF);
        highF = std::min(highestFrequency, best.frequency + widthF);
        lowD = std::max(0.0, best.decay - widthD);
        highD = best.decay + widthD;
    }
    return best;
}

} // namespace meltpool
