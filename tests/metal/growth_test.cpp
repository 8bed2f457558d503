// Growth of the metal beyond its first capacity for filler: the bits do not change, also from saved states of another
// capacity.
#include "core/gl/state_archive.hpp"
#include "core/metal/physical_metal.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cmath>

namespace meltpool {

namespace {

constexpr float kMm = 1e-3F;
constexpr int kGrown = 30; ///< number of steps after which metal with room for kRoom has grown
constexpr size_t kRoom = 40;

/// A clamped steel plate and a loose block that falls onto it, so that the lists of liquid metal and of fragments are
/// both in use. `room` is the capacity in particles of filler.
PhysicalSetup plateAndBlock(size_t room) {
    const glm::vec3 low = glm::vec3(-12, -8, -12) * kMm, high = glm::vec3(12, 8, 12) * kMm;
    PhysicalSetup setup;
    setup.material = shippedMaterial("s235");
    setup.lattice = MetalLattice::covering(low, high, kMm);
    setup.seeds =
        latticeSeeds(setup.lattice, glm::vec3(-12, -6, -10) * kMm, glm::vec3(12, -2, 10) * kMm, 293.15F, PHASE_CLAMPED);
    const auto block = latticeSeeds(setup.lattice, glm::vec3(4, 0, -6) * kMm, glm::vec3(9, 3, 6) * kMm, 293.15F);
    setup.seeds.insert(setup.seeds.end(), block.begin(), block.end());
    setup.fillerRoom = room;
    setup.space = {low, high};
    setup.fragments.floorHeight = -8 * kMm;
    setup.heat.ledger = true;
    return setup;
}

/// Adds two drops a step to a pool under an arc.
void weld(PhysicalMetal& metal, int from, int to) {
    const std::vector<HeatSource> burning{
        HeatSource::gaussian(glm::vec3(-4, -2, 0) * kMm, glm::vec3(0, -1, 0), 2 * kMm, 2500)};
    for (int step = from; step < to; ++step) {
        const float across = static_cast<float>(step % 5 - 2) * 2;
        std::vector<MetalSeed> drops;
        for (const float along : {-8.0F, -1.0F})
            drops.push_back({glm::vec3(along, 3, across) * kMm, 2200, PHASE_ALIVE | PHASE_LIQUID, {0, -0.3F, 0}});
        metal.step(burning, drops, nullptr);
    }
}

std::vector<std::byte> saved(PhysicalMetal& metal) {
    metal.xorOutDerivedState();
    gl::StateCapture capture;
    gl::StateArchive saving(capture.begin());
    metal.transfer(saving);
    capture.request();
    capture.wait();
    metal.xorOutDerivedState();
    std::vector<std::byte> bytes;
    std::vector<gl::StatePart> parts;
    capture.assemble(bytes, parts);
    return bytes;
}

void restore(PhysicalMetal& metal, const std::vector<std::byte>& bytes) {
    gl::StateArchive restoring{std::span<const std::byte>(bytes)};
    metal.transfer(restoring);
    CHECK(restoring.atEnd());
    metal.xorOutDerivedState();
}

} // namespace

TEST_CASE("metal that grows keeps its bits", "[physical]") {
    test::context();
    PhysicalMetal metal(test::shaders(), plateAndBlock(kRoom)), roomy(test::shaders(), plateAndBlock(3000));
    REQUIRE(roomy.fragments().report().particles == 5 * 3 * 12);
    const size_t before = metal.state().capacity(), bytes = metal.bytes();
    weld(metal, 0, kGrown);
    weld(roomy, 0, kGrown);
    CHECK(metal.state().capacity() > before);
    CHECK(metal.bytes() > bytes);
    CHECK(metal.state().particles() == before + 2 * kGrown - kRoom);
    CHECK(metal.refusedFiller() == 0);
    CHECK(metal.flow().readMoving() > 5 * 3 * 12 + 20);
    CHECK(metal.fragments().report().particles == 5 * 3 * 12);
    const std::uint64_t grown = metal.stateHash();
    CHECK(grown == roomy.stateHash());
    weld(metal, kGrown, 2 * kGrown);
    weld(roomy, kGrown, 2 * kGrown);
    const std::uint64_t end = metal.stateHash();
    CHECK(end != grown);
    CHECK(end == roomy.stateHash());
    CHECK_FALSE(metal.flow().readFaults().any());
    CHECK(metal.heat().readBalance().gained == roomy.heat().readBalance().gained);

    metal.reset();
    weld(metal, 0, kGrown);
    CHECK(metal.stateHash() == grown);
}

TEST_CASE("metal goes on from a saved state of less room and of more", "[physical]") {
    test::context();
    PhysicalMetal metal(test::shaders(), plateAndBlock(kRoom));
    constexpr int kSaved = 13; // inside a cycle of fragment labelling
    weld(metal, 0, kSaved);
    const size_t small = metal.state().capacity();
    const auto early = saved(metal);
    weld(metal, kSaved, kGrown);
    REQUIRE(metal.state().capacity() > small);
    const auto late = saved(metal);
    weld(metal, kGrown, 2 * kGrown);
    const std::uint64_t end = metal.stateHash();

    restore(metal, early);
    CHECK(metal.state().capacity() == small);
    weld(metal, kSaved, 2 * kGrown);
    CHECK(metal.stateHash() == end);

    PhysicalMetal fresh(test::shaders(), plateAndBlock(kRoom));
    restore(fresh, late);
    CHECK(fresh.state().capacity() > small);
    weld(fresh, kGrown, 2 * kGrown);
    CHECK(fresh.stateHash() == end);
}

} // namespace meltpool
