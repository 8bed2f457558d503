// Solid fragments: labels equal to a CPU flood fill's, free fall, rest, tipping over, constant shape and momentum.
#include "core/metal/rigid_fragments.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <random>

namespace meltpool {

namespace {

constexpr float kSpacing = 1e-3F;
constexpr float kStep = 1.0F / (90 * 16);

const HeatTable& steel() {
    static const HeatTable table(
        readMaterial(test::testFolder().parent_path() / "app" / "data" / "materials" / "s235.toml"));
    return table;
}

/// A lattice of 32 x 24 x 16 mm with its low corner at the origin; the floor is its bottom.
MetalLattice smallLattice() {
    return MetalLattice::covering(glm::vec3(0), glm::vec3(0.032F, 0.024F, 0.016F), kSpacing);
}

/// Returns the seeds of the box between two cells (the second excluded).
std::vector<MetalSeed> box(const MetalLattice& lattice, glm::ivec3 low, glm::ivec3 high, unsigned extra = 0) {
    return latticeSeeds(lattice, lattice.low + glm::vec3(low) * kSpacing, lattice.low + glm::vec3(high) * kSpacing, 293,
                        extra);
}

std::vector<MetalSeed> operator+(std::vector<MetalSeed> a, const std::vector<MetalSeed>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

struct Bench {
    explicit Bench(const std::vector<MetalSeed>& seeds, unsigned contactRoom = 8192)
        : state((test::context(), smallLattice()), steel(), 7850, seeds.size() + 8),
          fragments(test::shaders(), state,
                    {{0, 1, 0}, 0, 0.35F, contactRoom, glm::vec3(0), {0.032F, 0.024F, 0.016F}}) {
        state.add(seeds);
        fragments.relabelNow(nullptr);
    }

    void run(float seconds) {
        const int steps = static_cast<int>(std::lround(seconds / kStep));
        for (int step = 0; step < steps; ++step) {
            if (step % 16 == 0) fragments.relabel(nullptr);
            fragments.move(kStep, 1, nullptr);
        }
    }

    std::vector<vec4> positions() const { return state.position.read<vec4>(state.particles()); }
    std::vector<vec4> velocities() const { return state.velocity.read<vec4>(state.particles()); }
    std::vector<uint> phases() const { return state.phase.read<uint>(state.particles()); }
    unsigned fragmentOf(size_t slot) const { return (phases()[slot] & PHASE_FRAGMENT_BITS) >> PHASE_FRAGMENT_SHIFT; }

    void setPhases(const std::function<uint(size_t, uint)>& change) {
        auto bits = phases();
        for (size_t i = 0; i < bits.size(); ++i)
            bits[i] = change(i, bits[i]);
        state.phase.write(std::span<const uint>(bits));
    }

    MetalState state;
    RigidFragments fragments;
};

/// Returns the component of every solid particle by flood fill over all pairs closer than the bond length; SIZE_MAX for
/// others.
std::vector<size_t> floodFill(const std::vector<vec4>& positions, const std::vector<uint>& phases) {
    std::vector<size_t> component(positions.size(), SIZE_MAX);
    const float reach = static_cast<float>(FRAGMENT_BOND_LENGTH) * kSpacing;
    for (size_t root = 0; root < positions.size(); ++root) {
        if (component[root] != SIZE_MAX || (phases[root] & PHASE_LIQUID)) continue;
        std::vector<size_t> open{root};
        component[root] = root;
        while (!open.empty()) {
            const size_t i = open.back();
            open.pop_back();
            for (size_t j = 0; j < positions.size(); ++j)
                if (component[j] == SIZE_MAX && !(phases[j] & PHASE_LIQUID) &&
                    glm::distance(glm::vec3(positions[i]), glm::vec3(positions[j])) <= reach) {
                    component[j] = root;
                    open.push_back(j);
                }
        }
    }
    return component;
}

float largestStretch(const std::vector<vec4>& before, const std::vector<vec4>& after, size_t first, size_t last) {
    float largest = 0;
    for (size_t i = first + 1; i < last; ++i) {
        const float was = glm::distance(glm::vec3(before[i]), glm::vec3(before[first]));
        const float is = glm::distance(glm::vec3(after[i]), glm::vec3(after[first]));
        largest = std::max(largest, std::abs(is - was) / kSpacing);
    }
    return largest;
}

} // namespace

TEST_CASE("labelling lists the particles whose phase it changes, and what froze and has no label yet") {
    const MetalLattice lattice = smallLattice();
    // A clamped block is below one that hangs in the air.
    const auto held = box(lattice, {4, 0, 4}, {8, 4, 8}, PHASE_CLAMPED);
    const auto loose = box(lattice, {4, 10, 4}, {8, 12, 8});
    Bench bench(held + loose);
    const auto listed = [&] {
        auto changes = bench.state.changes.read<uint>(1 + bench.state.particles());
        std::vector<uint> slots(changes.begin() + 1, changes.begin() + 1 + changes[0]);
        std::sort(slots.begin(), slots.end());
        bench.state.changes.clear();
        return slots;
    };
    std::vector<uint> expected(loose.size());
    std::iota(expected.begin(), expected.end(), static_cast<uint>(held.size()));
    CHECK(listed() == expected); // fragments have left the lattice
    bench.fragments.relabelNow(nullptr);
    CHECK(listed().empty());
    bench.setPhases([](size_t slot, uint bits) { return slot == 3 ? bits | PHASE_FRESH : bits; });
    bench.fragments.relabelNow(nullptr);
    CHECK(listed() == std::vector<uint>{3});
    CHECK((bench.phases()[3] & PHASE_FRESH) == 0);
    // One slot melts now and freezes in the middle of a cycle that began without it.
    bench.setPhases([](size_t slot, uint bits) { return slot == 5 ? bits | PHASE_LIQUID : bits; });
    bench.fragments.relabel(nullptr);
    bench.setPhases([](size_t slot, uint bits) { return slot == 5 ? (bits & ~PHASE_LIQUID) | PHASE_FRESH : bits; });
    for (int call = 1; call < 26; ++call)
        bench.fragments.relabel(nullptr);
    CHECK(listed() == std::vector<uint>{5});
    CHECK((bench.phases()[5] & PHASE_FRESH) != 0);
}

TEST_CASE("fragments are labelled as a flood fill does, with metal missing at random") {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const MetalLattice lattice = smallLattice();
        auto seeds = box(lattice, {0, 0, 0}, {32, 1, 16}, PHASE_CLAMPED) + box(lattice, {0, 1, 0}, {32, 12, 16});
        std::mt19937 random(seed);
        for (MetalSeed& s : seeds) // few bonds, so that there are many islands
            if (!(s.phase & PHASE_CLAMPED) && random() % 100 < 66) s.phase |= PHASE_LIQUID;
        const Bench bench(seeds);
        std::vector<uint> startPhases;
        for (const MetalSeed& s : seeds)
            startPhases.push_back(s.phase);
        const auto expected = floodFill(bench.positions(), startPhases);
        std::vector<bool> clamped(seeds.size(), false);
        for (size_t i = 0; i < seeds.size(); ++i)
            if (expected[i] != SIZE_MAX && (startPhases[i] & PHASE_CLAMPED)) clamped[expected[i]] = true;
        std::vector<unsigned> numberOf(seeds.size(), 0);
        unsigned found = 0;
        for (size_t i = 0; i < seeds.size(); ++i)
            if (expected[i] == i && !clamped[i]) numberOf[i] = ++found;
        const auto phases = bench.phases();
        size_t wrong = 0;
        for (size_t i = 0; i < seeds.size(); ++i) {
            if (expected[i] == SIZE_MAX) continue;
            const unsigned number = numberOf[expected[i]] > FRAGMENT_MAX_COUNT ? 0 : numberOf[expected[i]];
            wrong += ((phases[i] & PHASE_FRAGMENT_BITS) >> PHASE_FRAGMENT_SHIFT) != number ? 1U : 0U;
        }
        CHECK(found > 20);
        CHECK(wrong == 0);
        CHECK(bench.fragments.report().fragments == std::min(found, unsigned(FRAGMENT_MAX_COUNT)));
    }
}

TEST_CASE("metal that winds through the whole lattice is one fragment, by one clamp") {
    const MetalLattice lattice = smallLattice();
    std::vector<MetalSeed> seeds;
    for (int row = 0; row < 24; ++row) { // full rows a spacing apart, each joined with the next at one end only
        if (row % 2 == 0) seeds = seeds + box(lattice, {0, row, 8}, {32, row + 1, 9});
        const int end = row % 4 == 1 ? 31 : 0;
        if (row % 2 == 1) seeds = seeds + box(lattice, {end, row, 8}, {end + 1, row + 1, 9});
    }
    for (const bool clamped : {false, true}) {
        if (clamped) seeds.back().phase |= PHASE_CLAMPED;
        const Bench bench(seeds);
        size_t others = 0;
        for (size_t slot = 0; slot < seeds.size(); ++slot)
            others += bench.fragmentOf(slot) != (clamped ? 0U : 1U) ? 1U : 0U;
        CHECK(others == 0);
        CHECK(bench.fragments.report().fragments == (clamped ? 0U : 1U));
    }
}

TEST_CASE("a slab falls from another in metal that takes several calls to label") {
    test::context();
    const auto lattice = MetalLattice::covering(glm::vec3(0), glm::vec3(0.064F, 0.032F, 0.064F), kSpacing);
    auto seeds = box(lattice, {0, 10, 0}, {64, 15, 64}) + box(lattice, {0, 16, 0}, {64, 21, 64});
    const size_t slab = seeds.size() / 2;
    seeds[0].phase |= PHASE_CLAMPED;
    MetalState state(lattice, steel(), 7850, seeds.size() + 8);
    state.add(seeds);
    RigidFragments fragments(test::shaders(), state,
                             {{0, 1, 0}, 0, 0.35F, 256, glm::vec3(0), {0.064F, 0.032F, 0.064F}});
    const auto isFree = [&](uint bits) { return (bits & PHASE_FRAGMENT_BITS) != 0; };
    const auto freeFrom = [&](size_t slot, size_t count) {
        const auto phases = state.phase.read<uint>(seeds.size());
        return std::count_if(phases.begin() + static_cast<std::ptrdiff_t>(slot),
                             phases.begin() + static_cast<std::ptrdiff_t>(slot + count), isFree);
    };
    for (int call = 0; call < 25; ++call)
        fragments.relabel(nullptr);
    CHECK(freeFrom(0, seeds.size()) == 0);
    fragments.relabel(nullptr); // last call of the cycle
    CHECK(freeFrom(0, slab) == 0);
    CHECK(freeFrom(slab, slab) == static_cast<std::ptrdiff_t>(slab));
}

TEST_CASE("a bridge cut through in the middle falls, comes to rest and is not left in the air") {
    const MetalLattice lattice = smallLattice();
    const auto left = box(lattice, {0, 0, 4}, {4, 14, 12}, PHASE_CLAMPED);
    const auto right = box(lattice, {28, 0, 4}, {32, 14, 12}, PHASE_CLAMPED);
    const auto bridge = box(lattice, {4, 11, 4}, {28, 14, 12});
    Bench bench(left + right + bridge);
    const size_t first = left.size() + right.size();
    const auto start = bench.positions();
    bench.run(0.05F);
    CHECK(bench.fragments.report().fragments == 0);
    CHECK(std::memcmp(start.data(), bench.positions().data(), start.size() * sizeof(vec4)) == 0);

    // Cuts at both ends free the middle part.
    bench.setPhases([&](size_t i, uint bits) {
        const float x = start[i].x;
        const bool cut = i >= first && (x < 0.006F || x > 0.026F);
        return cut ? (bits | PHASE_LIQUID) & ~uint(PHASE_LATTICE) : bits;
    });
    bench.fragments.relabelNow(nullptr);
    CHECK(bench.fragments.report().fragments == 1);
    const auto cutPositions = bench.positions();
    bench.run(0.03F);
    size_t inside = first;
    while (start[inside].x < 0.007F || start[inside].x > 0.025F)
        ++inside;
    const float fallen = start[inside].y - bench.positions()[inside].y;
    const float free = 0.5F * 9.81F * 0.03F * 0.03F;
    CHECK(fallen == Approx(free).epsilon(0.03));
    bench.run(0.8F);
    const auto end = bench.positions();
    float lowest = 1, fastest = 0;
    const auto velocities = bench.velocities();
    std::vector<size_t> fragment;
    for (size_t i = first; i < end.size(); ++i)
        if ((bench.phases()[i] & PHASE_FRAGMENT_BITS) != 0) fragment.push_back(i);
    REQUIRE(fragment.size() > 400);
    for (const size_t i : fragment) {
        lowest = std::min(lowest, end[i].y);
        fastest = std::max(fastest, glm::length(glm::vec3(velocities[i])));
    }
    CHECK(lowest == Approx(0.5F * kSpacing).margin(0.15F * kSpacing)); // on the floor, not inside it
    CHECK(fastest < 5e-3F);
    float stretch = 0;
    for (const size_t i : fragment)
        stretch = std::max(stretch,
                           std::abs(glm::distance(glm::vec3(end[i]), glm::vec3(end[fragment[0]])) -
                                    glm::distance(glm::vec3(cutPositions[i]), glm::vec3(cutPositions[fragment[0]]))));
    CHECK(stretch < 0.01F * kSpacing);
}

TEST_CASE("a slender fragment that stands askew tips over") {
    const MetalLattice lattice = smallLattice();
    Bench bench(box(lattice, {14, 1, 7}, {17, 17, 10}));
    auto positions = bench.positions();
    const float lean = 0.35F; // rad; a 3 x 16 column tips beyond atan(3/16) = 0.19
    for (vec4& p : positions) {
        const float x = p.x - 0.0155F, y = p.y;
        p.x = 0.0155F + std::cos(lean) * x + std::sin(lean) * y;
        p.y = 0.002F - std::sin(lean) * x + std::cos(lean) * y;
    }
    bench.state.position.write(std::span<const vec4>(positions));
    bench.run(0.6F);
    float highest = 0;
    for (const vec4& p : bench.positions())
        highest = std::max(highest, p.y);
    CHECK(highest < 0.0045F);
    CHECK(largestStretch(positions, bench.positions(), 0, positions.size()) < 0.02F);
}

TEST_CASE("a fragment that flies or is pressed against the sides of the space stays inside it") {
    const MetalLattice lattice = smallLattice();
    Bench bench(box(lattice, {14, 4, 6}, {18, 6, 10}));
    for (const glm::vec3 push :
         {glm::vec3(0.8F, 0, 0), {-0.8F, 0, 0}, {0, 0, 0.8F}, {0.2F, 0, -0.8F}, {0.8F, -1, 0.8F}}) {
        for (int blow = 0; blow < 20; ++blow) {
            const std::vector<vec4> velocities(bench.state.particles(), vec4(push, 0));
            bench.state.velocity.write(std::span<const vec4>(velocities));
            bench.run(0.02F);
            for (const vec4& p : bench.positions()) {
                CHECK(glm::all(glm::greaterThanEqual(glm::vec3(p), lattice.low)));
                CHECK(glm::all(glm::lessThanEqual(glm::vec3(p), glm::vec3(0.032F, 0.024F, 0.016F))));
            }
        }
        // It has moved to the side that it was pushed to.
        float reach = 0;
        for (const vec4& p : bench.positions())
            reach = std::max(reach, glm::dot(glm::vec3(p) - glm::vec3(0.016F, 0, 0.008F), glm::normalize(push)));
        CHECK(reach > 0.006F);
    }
}

TEST_CASE("a fragment in free flight keeps its momentum and its spin") {
    const MetalLattice lattice = smallLattice();
    Bench bench(box(lattice, {14, 8, 6}, {19, 11, 10}));
    bench.state.setGravity(glm::vec3(0));
    const glm::vec3 centre(0.0165F, 0.0095F, 0.008F), drift(0.01F, 0.02F, -0.005F), spin(3, 7, -5);
    auto velocities = bench.velocities();
    const auto positions = bench.positions();
    for (size_t i = 0; i < positions.size(); ++i)
        velocities[i] = vec4(drift + glm::cross(spin, glm::vec3(positions[i]) - centre), 0);
    bench.state.velocity.write(std::span<const vec4>(velocities));
    const auto momenta = [&] {
        glm::dvec3 linear(0), angular(0), middle(0);
        const auto p = bench.positions();
        const auto v = bench.velocities();
        for (const vec4& x : p)
            middle += glm::dvec3(glm::vec3(x)) / double(p.size());
        for (size_t i = 0; i < p.size(); ++i) {
            linear += glm::dvec3(glm::vec3(v[i]));
            angular += glm::cross(glm::dvec3(glm::vec3(p[i])) - middle, glm::dvec3(glm::vec3(v[i])));
        }
        return std::pair(linear, angular);
    };
    const auto [linearBefore, angularBefore] = momenta();
    bench.run(0.2F);
    const auto [linear, angular] = momenta();
    CHECK(glm::length(linear - linearBefore) < 1e-3 * glm::length(linearBefore));
    CHECK(glm::length(angular - angularBefore) < 0.01 * glm::length(angularBefore));
    CHECK(largestStretch(positions, bench.positions(), 0, positions.size()) < 0.01F);
}

TEST_CASE("metal that rests on metal is another fragment until something freezes between them") {
    const MetalLattice lattice = smallLattice();
    const auto plate = box(lattice, {0, 0, 0}, {32, 2, 16}, PHASE_CLAMPED);
    const auto block = box(lattice, {12, 4, 5}, {18, 7, 11});
    Bench bench(plate + block);
    CHECK(bench.fragments.report().fragments == 1);
    bench.run(0.6F);
    CHECK(bench.fragments.report().particles == block.size());
    CHECK(bench.positions()[plate.size()].y == Approx(2.5F * kSpacing).margin(0.2F * kSpacing));
    bench.setPhases([&](size_t i, uint bits) { return i == plate.size() ? bits | PHASE_FRESH : bits; });
    bench.fragments.relabelNow(nullptr);
    CHECK(bench.fragments.report().particles == 0);
    CHECK(bench.fragmentOf(plate.size()) == 0);
    const auto rest = bench.positions();
    bench.run(0.1F);
    CHECK(std::memcmp(rest.data(), bench.positions().data(), rest.size() * sizeof(vec4)) == 0);
}

TEST_CASE("fragments cost no dispatch while nothing is free") {
    const MetalLattice lattice = smallLattice();
    const bool clamped = GENERATE(true, false);
    Bench bench(box(lattice, {4, 6, 4}, {9, 10, 9}, clamped ? PHASE_CLAMPED : 0));
    constexpr int kSteps = 8, kPasses = 4, kBefore = 2; // passes of each step; passes before all steps
    const auto dispatches = [&] {
        const auto before = gl::dispatchCount();
        bench.fragments.move(kStep, kSteps, nullptr);
        return gl::dispatchCount() - before;
    };
    glFinish(); // the number of free particles has arrived
    CHECK(dispatches() == (clamped ? 0U : kBefore + kSteps * kPasses));
    CHECK(dispatches() == (clamped ? 0U : kBefore + kSteps * kPasses));
    bench.setPhases([](size_t, uint bits) { return bits & ~PHASE_CLAMPED; });
    bench.fragments.relabelNow(nullptr);
    CHECK(dispatches() == kBefore + kSteps * kPasses);
    glFinish();
    CHECK(dispatches() == kBefore + kSteps * kPasses);
}

TEST_CASE("fragments move the same whether their contacts are kept or found twice") {
    const auto run = [](unsigned contactRoom) {
        const MetalLattice lattice = smallLattice();
        Bench bench(box(lattice, {4, 1, 4}, {9, 5, 9}) + box(lattice, {6, 6, 5}, {12, 9, 10}), contactRoom);
        bench.run(0.1F);
        return bench.positions();
    };
    const auto kept = run(8192), few = run(100), none = run(0);
    CHECK(std::memcmp(kept.data(), few.data(), kept.size() * sizeof(vec4)) == 0);
    CHECK(std::memcmp(kept.data(), none.data(), kept.size() * sizeof(vec4)) == 0);
}

TEST_CASE("two runs of falling fragments give the same bits") {
    const auto once = [] {
        const MetalLattice lattice = smallLattice();
        Bench bench(box(lattice, {4, 6, 4}, {9, 10, 9}) + box(lattice, {6, 12, 5}, {12, 15, 10}) +
                    box(lattice, {20, 3, 3}, {25, 6, 12}));
        bench.run(0.25F);
        return bench.positions();
    };
    const auto a = once(), b = once();
    CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(vec4)) == 0);
}

} // namespace meltpool
