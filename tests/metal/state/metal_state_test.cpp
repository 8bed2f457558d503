// Facts that the metal's state knows without a readback.
#include "core/metal/state/metal_state.hpp"

#include "core/metal/material/materials.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

namespace meltpool {

TEST_CASE("boxes that share a face through the middles of cells share out the cells, and know where theirs end") {
    const auto lattice = MetalLattice::covering(glm::vec3(0), glm::vec3(8), 1);
    const glm::vec3 high(4, 3, 4);
    const auto under = latticeSeeds(lattice, glm::vec3(0), {4, 1.5F, 4}, 300);
    const auto over = latticeSeeds(lattice, {0, 1.5F, 0}, high, 300);
    CHECK(under.size() == 4 * 4);
    CHECK(over.size() == 2 * 4 * 4);
    CHECK(latticeBox(lattice, glm::vec3(0), {4, 1.5F, 4}).high == glm::vec3(4, 1, 4));
    const LatticeBox box = latticeBox(lattice, {0, 1.5F, 0.2F}, high);
    CHECK(box.low == glm::vec3(0, 1, 0));
    CHECK(box.high == high);
    const LatticeBox none = latticeBox(lattice, {0, 1.6F, 0}, {4, 2.4F, 4}); // between two cell centres
    CHECK(none.low.y == none.high.y);
    CHECK(none.high.x == 4);
}

TEST_CASE("the state knows the box of cells that metal was ever on the lattice in", "[physical]") {
    test::context();
    constexpr float kMm = 1e-3F;
    const Material material = shippedMaterial("s235");
    const HeatTable table(material);
    const auto lattice = MetalLattice::covering(glm::vec3(0), glm::vec3(16, 12, 8) * kMm, kMm);
    MetalState state(lattice, table, material.solidDensity.at(293.15), 2000);
    const auto inCell = [&](glm::ivec3 cell, uint phase) {
        return MetalSeed{lattice.centre(cell), 293.15F, phase, {}};
    };
    const auto add = [&](const std::vector<MetalSeed>& seeds) { state.add(seeds); };

    add({inCell({1, 9, 1}, PHASE_ALIVE | PHASE_LIQUID)});
    CHECK(state.latticeMetal().low == glm::ivec3(0)); // a drop is not on the lattice
    CHECK(state.latticeMetal().high == glm::ivec3(0));

    add({inCell({5, 4, 3}, PHASE_ALIVE | PHASE_LATTICE), inCell({7, 2, 3}, PHASE_ALIVE | PHASE_LATTICE)});
    CHECK(state.latticeMetal().low == glm::ivec3(5, 2, 3));
    CHECK(state.latticeMetal().high == glm::ivec3(7, 4, 3));

    add({inCell({6, 6, 1}, PHASE_ALIVE | PHASE_LATTICE)});
    CHECK(state.latticeMetal().low == glm::ivec3(5, 2, 1));
    CHECK(state.latticeMetal().high == glm::ivec3(7, 6, 3));

    state.reset();
    CHECK(state.latticeMetal().low == glm::ivec3(0));
    CHECK(state.latticeMetal().high == glm::ivec3(0));
}

} // namespace meltpool
