// The position of wire metal: on the plate, not inside it.
#include "core/metal/physical_metal.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

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
    setup.fragments.floorHeight = low.y;
    setup.fillerRoom = 100;
    return setup;
}

} // namespace

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
    CHECK(place.w < 1700); // the plate has absorbed its heat
    CHECK((metal.state().phase.read<uint>(1, slot * sizeof(uint))[0] & PHASE_LIQUID) == 0);
}
