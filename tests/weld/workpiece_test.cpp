// Workpieces have the metal their measures promise, clamps where they belong, and machines put in the power and wire
// they state.
#include "core/base/error.hpp"
#include "core/weld/process/filler.hpp"
#include "core/weld/workpiece.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace meltpool;

namespace {

size_t clampedIn(const Workpiece& piece) {
    return static_cast<size_t>(std::count_if(piece.seeds.begin(), piece.seeds.end(),
                                             [](const MetalSeed& s) { return (s.phase & PHASE_CLAMPED) != 0; }));
}

} // namespace

TEST_CASE("workpieces hold as many particles as their volume asks for") {
    WorkpieceParameters p;
    p.kind = static_cast<int>(WorkpieceKind::Plate);
    CHECK(makeWorkpiece(p).seeds.size() == 100u * 50 * 6);
    p.spacingMm = 0.5F;
    CHECK(makeWorkpiece(p).seeds.size() == 8u * 100 * 50 * 6);
    p.spacingMm = 1;
    p.kind = static_cast<int>(WorkpieceKind::Tee);
    CHECK(makeWorkpiece(p).seeds.size() == 100u * (50 * 6 + 6 * 25));
    p.kind = static_cast<int>(WorkpieceKind::Butt);
    p.gapMm = 2;
    CHECK(makeWorkpiece(p).seeds.size() == 100u * 48 * 6);
    p.kind = static_cast<int>(WorkpieceKind::Cube);
    p.lengthMm = 40;
    const Workpiece cube = makeWorkpiece(p);
    CHECK(cube.seeds.size() == 40u * 40 * 40);
    CHECK(clampedIn(cube) == 40u * 40);
    CHECK(cube.floorHeight == Approx(-0.02F));
}

TEST_CASE("every particle of every workpiece lies inside its space and none twice in one cell") {
    for (int kind = 0; kind < 6; ++kind) {
        WorkpieceParameters p;
        p.kind = kind;
        p.lengthMm = 32;
        p.widthMm = 24;
        p.spacingMm = 0.8F;
        const Workpiece piece = makeWorkpiece(p);
        std::vector<size_t> cells;
        for (const MetalSeed& seed : piece.seeds) {
            REQUIRE(piece.lattice.contains(piece.lattice.cellAt(seed.position)));
            cells.push_back(piece.lattice.index(piece.lattice.cellAt(seed.position)));
        }
        std::sort(cells.begin(), cells.end());
        CHECK(std::adjacent_find(cells.begin(), cells.end()) == cells.end());
        CHECK(clampedIn(piece) > 0);
        CHECK(clampedIn(piece) < piece.seeds.size());
    }
}

TEST_CASE("a workpiece finer than memory is refused in words") {
    WorkpieceParameters p;
    p.lengthMm = p.widthMm = 400;
    p.thicknessMm = 50;
    p.spacingMm = 0.2F;
    CHECK_THROWS_AS(makeWorkpiece(p), InputError);
}

TEST_CASE("filler is exact to one particle over any division of time") {
    Filler filler(1e-3F);
    size_t particles = 0;
    for (int i = 0; i < 977; ++i)
        particles += filler.feed(1.234e-10, glm::vec3(0), glm::vec3(0, -0.3F, 0), 2500).size();
    const double fed = 977 * 1.234e-10;
    CHECK(std::abs(double(particles) * 1e-9 - fed) < 1e-9);
    CHECK(filler.fed() == particles);
    const auto row = filler.feed(3e-9, glm::vec3(0, 0.01F, 0), glm::vec3(0, -0.3F, 0), 2500);
    REQUIRE(row.size() >= 3);
    CHECK(glm::distance(row[0].position, row[1].position) == Approx(1e-3F));
    CHECK((row[0].phase & PHASE_LIQUID) != 0);
}
