// Minutes of striking, welding, cooling and remelting: no metal is lost, every joule is accounted for, an undisturbed
// pool comes to rest, and a repeated weld gives equal bits.
#include "core/metal/physical_metal.hpp"
#include "core/weld/process/filler.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;
constexpr float kSpacing = 2 * kMm;
constexpr int kFramesASecond = 90;
constexpr float kDropTemperature = 2200;

/// Returns a small steel plate of 32 x 24 mm, 6 mm thick, clamped at its ends, in a draught that cools it between two
/// beads.
PhysicalSetup plate() {
    PhysicalSetup setup;
    setup.material = shippedMaterial("s235");
    const glm::vec3 low = glm::vec3(-24, -16, -16) * kMm, high = glm::vec3(24, 24, 16) * kMm;
    setup.lattice = MetalLattice::covering(low, high, kSpacing);
    setup.seeds = latticeSeeds(setup.lattice, glm::vec3(-16, -6, -12) * kMm, glm::vec3(16, 0, 12) * kMm, 293.15F);
    for (MetalSeed& seed : setup.seeds)
        if (std::abs(seed.position.x) > 14 * kMm) seed.phase |= PHASE_CLAMPED;
    setup.fillerRoom = 600;
    setup.space = {low, high};
    setup.fragments.floorHeight = -16 * kMm;
    setup.heat.convection = 1200;
    setup.heat.radiation = true;
    setup.heat.evaporation = true;
    setup.heat.ledger = true;
    return setup;
}

/// One bead of `seconds`: struck and held at one end, drawn to the other with wire, and cooled; then its middle is
/// melted again without wire and cools again.
class Beads {
  public:
    explicit Beads(double seconds) : metal_(test::shaders(), plate()), seconds_(seconds) {
        start_ = metal_.state().readEnergy();
    }

    void weld() {
        const int frames = static_cast<int>(seconds_ * kFramesASecond);
        for (int frame = 0; frame < frames; ++frame) {
            const float phase = static_cast<float>(frame) / static_cast<float>(frames);
            const float lane = static_cast<float>(beads_ % 3 - 1) * 5 * kMm;
            const bool drawn = phase<0.35F, again = phase> 0.7F && phase < 0.8F;
            const float along = drawn ? std::max(0.0F, phase - 0.05F) / 0.3F * 20 * kMm - 10 * kMm : 0.0F;
            step(glm::vec3(along, 0, lane), drawn || again, drawn);
        }
        ++beads_;
    }

    /// Checks the laws that hold at any moment.
    void check() {
        const MetalStatistics now = metal_.statistics();
        CHECK(now.particles == plate().seeds.size() + fed_);
        CHECK(now.lost == 0);
        CHECK(now.nonFinite == 0);
        CHECK(metal_.refusedFiller() == 0);
        CHECK_FALSE(metal_.flow().readFaults().any());
        const HeatBalance balance = metal_.heat().readBalance();
        const double input = balance.gained + fedEnergy_;
        CHECK(balance.gained == Approx(arcEnergy_).epsilon(2e-3)); // all the arc's power reaches the metal
        CHECK(std::abs(metal_.state().readEnergy() - start_ - input + balance.lost) < 1e-4 * input);
        CHECK(balance.lost > 0);
        checkRest();
    }

    /// Checks that a frozen bead is at rest to the last bit and that remaining liquid only creeps, with no net
    /// direction.
    void checkRest() const {
        const size_t count = metal_.state().particles();
        const auto velocities = metal_.state().velocity.read<vec4>(count);
        const auto phases = metal_.state().phase.read<uint>(count);
        double stillSpeed = 0, liquid = 0;
        glm::dvec3 sum(0);
        for (size_t i = 0; i < count; ++i) {
            const glm::dvec3 velocity(velocities[i]);
            sum += velocity;
            if (phases[i] & PHASE_LIQUID)
                liquid += 1;
            else if ((phases[i] & PHASE_FRAGMENT_BITS) == 0)
                stillSpeed = std::max(stillSpeed, glm::length(velocity));
        }
        CHECK(stillSpeed == 0);
        CHECK(glm::length(sum) <= 3e-3 * liquid); // m/s times particles: momentum over a particle's mass
    }

    const PhysicalMetal& metal() const { return metal_; }
    size_t fed() const { return fed_; }
    unsigned mostMoving() const { return mostMoving_; }

  private:
    void step(glm::vec3 place, bool burns, bool feeds) {
        constexpr float kPower = 3200;
        std::vector<HeatSource> sources;
        if (burns) {
            sources.push_back(HeatSource::gaussian(place, glm::vec3(0, -1, 0), 3 * kMm, kPower));
            arcEnergy_ += static_cast<double>(kPower) / kFramesASecond;
        }
        std::span<const MetalSeed> drops;
        if (feeds)
            drops = filler_.feed(0.2e-9, place + glm::vec3(0, 12 * kMm, 0), glm::vec3(0, -0.3F, 0), kDropTemperature);
        fed_ += drops.size();
        fedEnergy_ += static_cast<double>(drops.size()) * metal_.state().particleMass() *
                      metal_.table().enthalpyAt(static_cast<double>(kDropTemperature));
        metal_.step(sources, drops, nullptr);
        if (++frames_ % kFramesASecond == 0) mostMoving_ = std::max(mostMoving_, metal_.flow().readMoving());
    }

    PhysicalMetal metal_;
    Filler filler_{kSpacing};
    double seconds_;
    double start_ = 0, arcEnergy_ = 0, fedEnergy_ = 0;
    size_t fed_ = 0;
    unsigned mostMoving_ = 0;
    int beads_ = 0, frames_ = 0;
};

/// Returns the state's hash after each bead.
std::vector<std::uint64_t> hashesOf(int beads, double seconds) {
    Beads run(seconds);
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < beads; ++i) {
        run.weld();
        hashes.push_back(run.metal().stateHash());
    }
    return hashes;
}

/// Welds this number of beads and checks after each; a second weld must give equal bits.
void soak(int beads, double seconds) {
    std::vector<std::uint64_t> hashes;
    Beads run(seconds);
    for (int i = 0; i < beads; ++i) {
        INFO("bead " << i + 1);
        run.weld();
        run.check();
        hashes.push_back(run.metal().stateHash());
    }
    CHECK(run.fed() > static_cast<size_t>(beads));
    CHECK(run.mostMoving() > 8);
    CHECK(hashesOf(beads, seconds) == hashes);
}

double rmsSpeed(const PhysicalMetal& metal, size_t& liquid) {
    const size_t count = metal.state().particles();
    const auto velocities = metal.state().velocity.read<vec4>(count);
    const auto phases = metal.state().phase.read<uint>(count);
    double sum = 0;
    liquid = 0;
    for (size_t i = 0; i < count; ++i)
        if (phases[i] & PHASE_LIQUID) {
            const glm::dvec3 speed(velocities[i]);
            sum += glm::dot(speed, speed);
            ++liquid;
        }
    return std::sqrt(sum / static_cast<double>(std::max<size_t>(liquid, 1)));
}

} // namespace

TEST_CASE("a few beads and remelting lose nothing", "[soak]") {
    test::context();
    soak(2, 6);
}

TEST_CASE("ten minutes of beads and remelting lose nothing", "[soak][long]") {
    test::context();
    soak(20, 30);
}

TEST_CASE("a pool left alone comes to rest", "[soak]") {
    test::context();
    PhysicalSetup setup = plate();
    setup.heat.convection = 0;
    setup.heat.radiation = setup.heat.evaporation = false;
    // An insulated pit full of liquid in metal just below its solidus neither spreads nor freezes.
    for (MetalSeed& seed : setup.seeds) {
        seed.temperature = 1765;
        const glm::vec3 p = seed.position;
        if (p.y < -4 * kMm || std::abs(p.x) > 8 * kMm || std::abs(p.z) > 8 * kMm) continue;
        seed.temperature = 1950;
        seed.phase = PHASE_ALIVE | PHASE_LIQUID;
        seed.velocity = glm::vec3(0.05F, 0, 0.02F);
    }
    PhysicalMetal metal(test::shaders(), setup);
    size_t liquid = 0;
    const double start = rmsSpeed(metal, liquid);
    const size_t pool = liquid;
    for (int frame = 0; frame < 12 * kFramesASecond; ++frame) {
        metal.step({}, {}, nullptr);
    }
    const double rest = rmsSpeed(metal, liquid);
    CHECK(start > 0.05);
    CHECK(liquid > pool / 2);
    CHECK(rest <= 3e-3);
}

TEST_CASE("a pool 10 mm deep comes to rest in a steel plate", "[soak]") {
    test::context();
    PhysicalSetup setup = plate();
    setup.heat.convection = 0;
    setup.heat.radiation = setup.heat.evaporation = false;
    const glm::vec3 low = glm::vec3(-8, -14, -8) * kMm, high = glm::vec3(8, 8, 8) * kMm;
    setup.lattice = MetalLattice::covering(low, high, kMm);
    setup.space = {low, high};
    setup.fragments.floorHeight = low.y;
    setup.seeds = latticeSeeds(setup.lattice, low, {high.x, 0, high.z}, 1765, PHASE_CLAMPED);
    for (MetalSeed& seed : setup.seeds) {
        const glm::vec3 p = seed.position;
        if (p.y < -10 * kMm || std::abs(p.x) > 5 * kMm || std::abs(p.z) > 5 * kMm) continue;
        seed.temperature = 1950;
        seed.phase = PHASE_ALIVE | PHASE_LIQUID;
        seed.velocity = glm::vec3(0.05F, 0, 0.02F);
    }
    PhysicalMetal metal(test::shaders(), setup);
    size_t liquid = 0;
    double square = 0, samples = 0;
    for (float time = 0; time < 1.6F; time += metal.timeStep()) {
        metal.step({}, {}, nullptr);
        if (time < 1) continue;
        const double speed = rmsSpeed(metal, liquid);
        square += speed * speed;
        samples += 1;
    }
    CHECK(liquid > 300);
    CHECK(std::sqrt(square / samples) <= 3e-3);
}

} // namespace meltpool
