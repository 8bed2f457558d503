// Where the joules go: an arc melts a plate, at a spot or along a seam, with wire or without; the metal flows and
// freezes.
#include "core/metal/physical_metal.hpp"
#include "core/validation/case_size.hpp"
#include "core/validation/heat_bench.hpp"
#include "core/weld/process/filler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meltpool {

namespace {

constexpr float kSide = 0.032F; // m, of the plate; longer where the seam needs it
constexpr float kThickness = 0.008F;
constexpr float kAir = 0.008F;    // m of lattice over the plate, for wire metal
constexpr float kMargin = 0.008F; // m between the seam's ends and the plate's
constexpr double kAmbient = 293.15;
constexpr float kWireTemperature = 2500; // K, of wire metal that leaves the wire
constexpr float kWireSpeed = 0.3F;       // m/s

/// The case in SI. x along the seam, the plate's low corner at 0.
struct Weld {
    double power, on, wireRate; // W, s, m³/s
    float speed, length, sigma;

    explicit Weld(const ValidationCase& from)
        : power(from.number("power_w")),
          on(std::min(from.number("on_s"), from.time)),
          wireRate(std::numbers::pi / 4 * std::pow(from.number("wire_diameter_mm") * 1e-3, 2) *
                   from.number("wire_feed_m_min") / 60),
          speed(static_cast<float>(from.number("speed_mm_s") * 1e-3)),
          length(std::max(kSide, speed * static_cast<float>(on) + 2 * kMargin)),
          sigma(std::max(0.0015F, 1.5F * static_cast<float>(from.spacing))) {}

    glm::vec3 place(double time) const {
        const float start = 0.5F * (length - speed * static_cast<float>(on));
        return {start + speed * static_cast<float>(time), kThickness, kSide / 2};
    }
};

PhysicalSetup setupOf(const ValidationCase& from, const Weld& weld) {
    PhysicalSetup setup;
    setup.material = from.material;
    const auto spacing = static_cast<float>(from.spacing);
    const glm::vec3 plate(weld.length, kThickness, kSide);
    setup.lattice = MetalLattice::covering(glm::vec3(0), plate + glm::vec3(0, kAir, 0), spacing);
    requireSpacings(from, "on a plate of 32x8x32 mm, its thickness", static_cast<double>(kThickness), 1);
    const auto cells = static_cast<double>(setup.lattice.cellCount());
    const double plateCount = static_cast<double>(plate.x * plate.y * plate.z) / std::pow(from.spacing, 3);
    const double count = plateCount + weld.wireRate * weld.on / std::pow(from.spacing, 3);
    requireRoom(from, {cells, count, count, cells});
    setup.seeds = latticeSeeds(setup.lattice, glm::vec3(0), plate, static_cast<float>(kAmbient), PHASE_CLAMPED);
    setup.space.low = setup.lattice.low;
    setup.space.high = setup.lattice.low + glm::vec3(setup.lattice.cells()) * spacing;
    const double coefficient = from.number("loss");
    setup.heat.ambient = kAmbient;
    setup.heat.convection = coefficient;
    setup.heat.radiation = setup.heat.evaporation = coefficient > 0;
    setup.heat.ledger = true;
    setup.fillerRoom = static_cast<size_t>(1.01 * weld.wireRate * weld.on / std::pow(from.spacing, 3)) + 10;
    return setup;
}

} // namespace

void runEnergy(const ValidationCase& from, gl::ShaderLibrary& shaders, ValidationResult& result) {
    const Weld weld(from);
    PhysicalMetal metal(shaders, setupOf(from, weld));
    Filler filler(static_cast<float>(from.spacing));
    const double before = metal.state().readEnergy();
    const size_t plate = metal.state().particles();
    const auto frame = static_cast<double>(metal.timeStep());
    double put = 0, peak = 0;
    const auto frames = static_cast<size_t>(std::ceil(from.time / frame));
    for (size_t i = 0; i < frames; ++i) {
        // Sources stand where they are in the middle of a frame; the last one burns for what is left of its time.
        const double time = static_cast<double>(i) * frame;
        const double share = std::clamp((weld.on - time) / frame, 0.0, 1.0);
        std::vector<HeatSource> sources;
        std::span<const MetalSeed> drops;
        if (share > 0) {
            const glm::vec3 place = weld.place(time + 0.5 * share * frame);
            sources.push_back(
                HeatSource::gaussian(place, {0, -1, 0}, weld.sigma, static_cast<float>(weld.power * share)));
            put += static_cast<double>(sources[0].power) * frame;
            drops = filler.feed(weld.wireRate * share * frame, place + glm::vec3(0, 0.5F * kAir, 0),
                                {weld.speed, -kWireSpeed, 0}, kWireTemperature);
        }
        metal.step(sources, drops, nullptr);
        constexpr size_t kLook = 30; // frames between two looks at what is molten
        if (i % kLook == kLook - 1) peak = std::max(peak, static_cast<double>(metal.statistics().molten));
    }
    result.steps = frames;
    const MetalStatistics end = metal.statistics();
    result.particles = end.particles;
    const HeatBalance balance = metal.heat().readBalance();
    const double change = metal.state().readEnergy() - before;
    const double wire = static_cast<double>(filler.fed()) * metal.state().particleMass() *
                        metal.table().enthalpyAt(static_cast<double>(kWireTemperature));
    const double input = put + wire;
    const double scale = input > 0 ? input : before;
    result.compareExact(from, "energy_change_j", input - balance.lost, change, scale);
    result.compareExact(from, "source_j", put, balance.gained, scale);
    result.tell("wire_j", wire);
    result.tell("lost_j", balance.lost);
    result.tell("balance_percent", 100 * std::abs(change - wire - balance.gained + balance.lost) / scale);
    const auto all = static_cast<double>(end.particles);
    result.tell("molten_peak_share", peak / all);
    result.tell("molten_end_share", static_cast<double>(end.molten) / all);
    // Every particle of plate and wire is still there.
    result.compareLimit("particles_missing", 0, static_cast<double>(plate + filler.fed()) - all);
    result.compareLimit("particles_lost_or_not_finite", 0, static_cast<double>(end.lost + end.nonFinite));
}

} // namespace meltpool
