// Beads: the section is measured right, wire metal lies on the plate and not in it, and its amount is exact.
#include "core/metal/physical_metal.hpp"
#include "core/validation/validation.hpp"
#include "core/weld/gauge/weld_section.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cmath>

using namespace meltpool;

namespace {

constexpr float kSpacing = 1e-3F;

Material steel() {
    return readMaterial(test::testFolder().parent_path() / "app" / "data" / "materials" / "s235.toml");
}

PhysicalSetup plateSetup(glm::vec3 low, glm::vec3 high) {
    PhysicalSetup setup;
    setup.material = steel();
    setup.lattice = MetalLattice::covering(low, high + glm::vec3(0, 8 * kSpacing, 0), kSpacing);
    setup.seeds = latticeSeeds(setup.lattice, low, high, 293, PHASE_CLAMPED);
    setup.space.low = setup.lattice.low;
    setup.space.high = setup.lattice.low + glm::vec3(setup.lattice.cells()) * kSpacing;
    setup.pieces.floorHeight = low.y;
    setup.fillerRoom = 100;
    return setup;
}

} // namespace

TEST_CASE("A section is measured from the highest temperatures", "[section]") {
    test::context();
    const Material m = steel();
    const MetalLattice lattice = MetalLattice::covering({0, -8 * kSpacing, -12 * kSpacing},
                                                        {8 * kSpacing, 4 * kSpacing, 12 * kSpacing}, kSpacing);
    auto seeds = latticeSeeds(lattice, lattice.low, {8 * kSpacing, 0, 12 * kSpacing}, 300);
    // Peaks fall linearly from the seam: 2000 K there, 100 K less each millimetre across, 200 K each millimetre down.
    for (MetalSeed& seed : seeds)
        seed.temperature = 2000 - 1e5F * std::abs(seed.position.z) + 2e5F * seed.position.y;
    const size_t plate = seeds.size();
    for (int i = 0; i < 8; ++i) // a bead of three rows and one on top of them
        for (int j = -1; j <= 2; ++j) {
            const float x = (static_cast<float>(i) + 0.5F) * kSpacing;
            const glm::vec3 place = j < 2 ? glm::vec3(x, 0.5F * kSpacing, static_cast<float>(j) * kSpacing)
                                          : glm::vec3(x, 1.5F * kSpacing, 0);
            seeds.push_back({place, 2000, PHASE_ALIVE, glm::vec3(0)});
        }
    MetalState state(lattice, HeatTable(m), 7850, seeds.size());
    state.add(seeds);
    REQUIRE(plate == 8 * 8 * 24);
    const SectionCut cut{0, 8e-3, 0, 8e-3, 1500, 1000};
    const Section section = measureSection(state, cut);
    CHECK(section.width * 1e3 == Approx(2 * (500.0 - 100) / 100).margin(0.05)); // at half a millimetre's depth
    CHECK(section.penetration * 1e3 == Approx(450.0 / 200).margin(0.05));       // half a millimetre beside the seam
    CHECK(section.heatAffectedDepth * 1e3 == Approx(950.0 / 200).margin(0.05));
    CHECK(section.deposited * 1e6 == Approx(4));
    CHECK(section.height * 1e3 == Approx(4.0 / 3).margin(0.01)); // evened over three columns
    // The same when the molten part has left the lattice.
    auto phases = state.phase.read<uint>(state.particles());
    for (size_t i = 0; i < plate; ++i)
        if (seeds[i].temperature > 1500) phases[i] &= ~PHASE_LATTICE;
    state.phase.write(std::span<const uint>(phases));
    const Section gone = measureSection(state, cut);
    CHECK(gone.width == Approx(section.width).margin(1e-5));
    CHECK(gone.penetration == Approx(section.penetration).margin(1e-5));
}

TEST_CASE("A drop that falls on a cold plate stays on it", "[physical]") {
    const auto setup = plateSetup({0, -6 * kSpacing, 0}, {12 * kSpacing, 0, 12 * kSpacing});
    PhysicalMetal metal(test::shaders(), setup);
    const float speed = GENERATE(0.2F, 1.0F);
    const std::vector<MetalSeed> drop{
        {{6.3F * kSpacing, 4 * kSpacing, 6.2F * kSpacing}, 2500, PHASE_ALIVE | PHASE_LIQUID, {0, -speed, 0}}};
    metal.step({}, drop, nullptr);
    for (int i = 0; i < 30; ++i)
        metal.step({}, {}, nullptr);
    const size_t slot = metal.state().particles() - 1;
    const vec4 place = metal.state().position.read<vec4>(1, slot * sizeof(vec4))[0];
    CHECK(place.y > 0.2F * kSpacing);
    CHECK(place.y < 1.2F * kSpacing);
    CHECK(place.w < 1700); // the plate has taken its heat
    CHECK((metal.state().phase.read<uint>(1, slot * sizeof(uint))[0] & PHASE_LIQUID) == 0);
}

TEST_CASE("A measured bead is met", "[validation]") {
    const auto file = test::testFolder() / "validation" / "cases" / "bead_32_5v_325a_15.toml";
    const ValidationResult result = runValidationCase(readValidationCase(file), test::shaders());
    INFO(validationText(result));
    CHECK(result.passed());
}
