// What a frame of the physical metal costs under a moving arc with wire: a plate of 100x50x6 mm at 1 mm and one of four
// times the area.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "core/metal/filler.hpp"
#include "core/metal/physical_metal.hpp"
#include "core/weld/workpiece.hpp"

#include <algorithm>
#include <ctime>
#include <limits>
#include <numbers>

namespace meltpool {

namespace {

constexpr float kPower = 2400;           // W that reach the plate, as of a GMAW arc of 3.2 kW
constexpr float kSigma = 2e-3F;          // m
constexpr float kSpeed = 10e-3F;         // m/s of travel
constexpr double kWireDiameter = 1.0e-3; // m
constexpr double kWireSpeed = 7.0 / 60;  // m/s
constexpr float kWireTemperature = 2300; // K
constexpr float kDropSpeed = 0.4F;       // m/s
constexpr int kWarmUp = 135;             // frames until the pool has its size

/// A bead along x in the middle of a plate.
class Bead {
  public:
    Bead(Bench& bench, float lengthMm, float widthMm) : metal_(bench.shaders(), setupOf(lengthMm, widthMm)) {
        for (int i = 0; i < kWarmUp; ++i)
            step(nullptr);
    }

    void step(gl::Profiler* profiler) {
        place_.x += kSpeed * metal_.timeStep();
        const HeatSource arc = HeatSource::gaussian(place_, glm::vec3(0, -1, 0), kSigma, kPower);
        const double volume =
            std::numbers::pi / 4 * kWireDiameter * kWireDiameter * kWireSpeed * static_cast<double>(metal_.timeStep());
        const auto drops =
            filler_.feed(volume, place_ + glm::vec3(0, 8e-3F, 0), glm::vec3(0, -kDropSpeed, 0), kWireTemperature);
        metal_.step(std::span(&arc, 1), drops, profiler);
    }

    const PhysicalMetal& metal() const { return metal_; }

  private:
    static PhysicalSetup setupOf(float lengthMm, float widthMm) {
        WorkpieceParameters parameters;
        parameters.lengthMm = lengthMm;
        parameters.widthMm = widthMm;
        const Workpiece piece = makeWorkpiece(parameters);
        PhysicalSetup setup;
        setup.material = workpieceMaterial(parameters);
        setup.lattice = piece.lattice;
        setup.seeds = piece.seeds;
        setup.space = {piece.low, piece.high};
        setup.pieces.floorHeight = piece.floorHeight;
        setup.heat.convection = 15;
        setup.heat.radiation = true;
        setup.heat.evaporation = true;
        return setup;
    }

    PhysicalMetal metal_;
    Filler filler_{1e-3F};
    glm::vec3 place_{-20e-3F, 0, 0}; // where the arc meets the plate
};

double further(const BenchRow& row, std::string_view name) {
    const auto found =
        std::find_if(row.further.begin(), row.further.end(), [&](const auto& f) { return f.first == name; });
    return found == row.further.end() ? 0 : found->second;
}

BenchRow measureBead(Bench& bench, const std::string& what, float lengthMm, float widthMm) {
    Bead bead(bench, lengthMm, widthMm);
    double processor = std::numeric_limits<double>::infinity();
    BenchRow row = bench.measure(
        what,
        [&](gl::Profiler& profiler) {
            const std::clock_t start = std::clock();
            bead.step(&profiler);
            glFinish();
            processor = std::min(processor, static_cast<double>(std::clock() - start) * 1e3 / CLOCKS_PER_SEC);
        },
        1.0, 20, 60);
    row.particles = bead.metal().particles().count;
    row.bytes = bead.metal().bytes();
    row.bytesPerParticle = static_cast<double>(row.bytes) / static_cast<double>(row.particles);
    row.further = {{"times_real_time", static_cast<double>(bead.metal().timeStep()) * 1e3 / row.stepMs},
                   {"cpu_ms", processor},
                   {"moving", bead.metal().flow().readMoving()},
                   {"heat_tiles", bead.metal().heat().readActiveTiles()}};
    return row;
}

} // namespace

void benchWeldMetal(Bench& bench) {
    const BenchRow small = measureBead(bench, "physics, 100x50x6 mm", 100, 50);
    BenchRow large = measureBead(bench, "physics, 200x100x6 mm", 200, 100);
    large.further.emplace_back("over_small", large.stepMs / small.stepMs);
    large.further.emplace_back("over_small_cpu", further(large, "cpu_ms") / further(small, "cpu_ms"));
    bench.add(small);
    bench.add(std::move(large));
}

} // namespace meltpool
