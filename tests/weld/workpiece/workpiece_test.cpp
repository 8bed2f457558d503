// Workpieces: metal of the stated measures, clamps at the right places, and the stated power and wire of machines.
#include "core/base/error.hpp"
#include "core/weld/process/filler.hpp"
#include "core/weld/workpiece/position.hpp"
#include "core/weld/workpiece/workpiece.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

using namespace meltpool;

namespace {

size_t clampedIn(const Workpiece& piece) {
    return static_cast<size_t>(std::count_if(piece.seeds.begin(), piece.seeds.end(),
                                             [](const MetalSeed& s) { return (s.phase & PHASE_CLAMPED) != 0; }));
}

/// Returns the volume, mm³.
double volumeOf(const Workpiece& piece) {
    const double edge = static_cast<double>(piece.lattice.spacing) * 1e3;
    return static_cast<double>(piece.seeds.size()) * edge * edge * edge;
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

TEST_CASE("bevels take their triangles off the edges of a butt joint") {
    WorkpieceParameters p;
    p.kind = static_cast<int>(WorkpieceKind::Butt);
    p.lengthMm = 40;
    p.thicknessMm = 10;
    p.gapMm = 2;
    p.rootFaceMm = 2;
    for (const double spacing : {1.0, 0.5})
        for (const double bevel : {0.0, 22.5, 30.0, 45.0}) {
            INFO(bevel << " degrees of particles of " << spacing << " mm");
            p.spacingMm = static_cast<float>(spacing);
            p.bevelDeg = static_cast<float>(bevel);
            const double rise = 8, run = rise * std::tan(bevel * std::numbers::pi / 180);
            const double exact = 40 * (10 * 48 - rise * run);
            // The bevelled face of a lattice is within half a spacing.
            CHECK(volumeOf(makeWorkpiece(p)) == Approx(exact).margin(40 * std::hypot(rise, run) * spacing + 1e-3));
        }
    p.bevelDeg = 30;
    for (const MetalSeed& seed : makeWorkpiece(p).seeds) {
        const glm::vec3 at = seed.position * 1e3F;
        const float open = 1 + std::max(at.y + 8, 0.0F) * std::tan(30 * std::numbers::pi_v<float> / 180);
        CHECK(std::abs(at.z) >= open - 1e-3F);
    }
}

TEST_CASE("an outside corner's plates meet in a line, with the groove between their edges") {
    WorkpieceParameters p;
    p.kind = static_cast<int>(WorkpieceKind::Corner);
    const Workpiece corner = makeWorkpiece(p);
    CHECK(corner.seeds.size() == 100u * (25 * 6 + 25 * 6));
    CHECK(corner.bodyHigh == glm::vec3(50, 6, 6) * 1e-3F);
    CHECK(corner.bodyLow == glm::vec3(-50, -25, -25) * 1e-3F);
    for (const MetalSeed& seed : corner.seeds)
        CHECK((seed.position.y > 0) != (seed.position.z > 0));
}

TEST_CASE("a pipe is a tube, parted where it has a gap, and clamped at its ends") {
    WorkpieceParameters p;
    p.kind = static_cast<int>(WorkpieceKind::Pipe);
    p.diameterMm = 50;
    p.thicknessMm = 5;
    p.widthMm = 40;
    for (const double spacing : {1.0, 0.5})
        for (const double gap : {0.0, 2.0})
            for (const double bevel : {0.0, 30.0}) {
                INFO(gap << " mm of gap, " << bevel << " degrees, particles of " << spacing << " mm");
                p.spacingMm = static_cast<float>(spacing);
                p.gapMm = static_cast<float>(gap);
                p.rootFaceMm = 1;
                p.bevelDeg = static_cast<float>(bevel);
                const Workpiece pipe = makeWorkpiece(p);
                const double run = 4 * std::tan(bevel * std::numbers::pi / 180);
                const double exact = std::numbers::pi * (5 * 45 * (40 - gap) - 2 * (25 - 4.0 / 3) * run * 4);
                CHECK(volumeOf(pipe) == Approx(exact).epsilon(0.02));
                CHECK(clampedIn(pipe) > 0);
                REQUIRE(pipe.pipe); // the picture's faces are on its circles
                CHECK(pipe.pipe->outer == Approx(0.025));
                CHECK(pipe.pipe->inner == Approx(0.020));
                CHECK(pipe.pipe->axis.y == Approx(-0.025));
                CHECK(pipe.pipe->high - pipe.pipe->low == Approx(0.040));
                for (const MetalSeed& seed : pipe.seeds) {
                    const glm::vec3 at = seed.position * 1e3F;
                    const float radius = std::hypot(at.x, at.y + 25);
                    REQUIRE(radius < 25.001F);
                    REQUIRE(radius > 19.999F);
                    REQUIRE(std::abs(static_cast<double>(at.z)) > gap / 2);
                    if (seed.phase & PHASE_CLAMPED) REQUIRE(std::abs(at.z) > 15.9F);
                }
            }
    p.gapMm = 0;
    p.bevelDeg = 0;
    p.widthMm = 41; // a layer of cells is in the middle
    CHECK(volumeOf(makeWorkpiece(p)) == Approx(std::numbers::pi * 5 * 45 * 41).epsilon(0.02));
}

TEST_CASE("tacks join the parts where the seam will be, from end to end, and are no part of them") {
    for (const WorkpieceKind kind :
         {WorkpieceKind::Tee, WorkpieceKind::Lap, WorkpieceKind::Corner, WorkpieceKind::Butt, WorkpieceKind::Pipe}) {
        INFO(static_cast<int>(kind));
        WorkpieceParameters p;
        p.kind = static_cast<int>(kind);
        p.gapMm = 2;
        p.rootFaceMm = 2;
        p.bevelDeg = 30;
        p.spacingMm = 0.5F;
        const Workpiece bare = makeWorkpiece(p);
        CHECK(bare.tackSeeds == 0);
        p.tackCount = 3;
        p.tackLengthMm = 8;
        const Workpiece piece = makeWorkpiece(p);
        REQUIRE(piece.parts().size() == bare.seeds.size());
        for (size_t i = 0; i < bare.seeds.size(); ++i)
            REQUIRE(piece.seeds[i].position == bare.seeds[i].position);
        REQUIRE(piece.seeds.size() == bare.seeds.size() + piece.tackSeeds);
        const bool corner = kind != WorkpieceKind::Butt && kind != WorkpieceKind::Pipe;
        // The bevel is a triangle of half the plate's thickness; a groove has a root face of 2 mm and 1 mm of bevel.
        const double area = corner ? 0.5 * 3 * 3 : 2 * 3 + std::tan(std::numbers::pi / 6);
        // The length of a pipe's tack is measured on its outer face.
        const double length = kind == WorkpieceKind::Pipe ? 8 * 25.5 / 30 : 8;
        CHECK(static_cast<double>(piece.tackSeeds) * 0.125 == Approx(3 * length * area).epsilon(0.2));
        if (kind == WorkpieceKind::Pipe) continue;
        float low = 1, high = -1;
        for (const MetalSeed& seed : std::span(piece.seeds).last(piece.tackSeeds)) {
            const float x = seed.position.x * 1e3F;
            low = std::min(low, x);
            high = std::max(high, x);
            CHECK((std::abs(x) < 4 || std::abs(x) > 42)); // in the middle and at both ends
        }
        CHECK(low == Approx(-49.75F));
        CHECK(high == Approx(49.75F));
    }
}

TEST_CASE("sizes that cannot be are refused in one sentence that names the value to change") {
    struct Case {
        WorkpieceKind kind;
        void (*spoil)(WorkpieceParameters&);
        std::string key, expectation;
    };
    const std::vector<Case> cases{
        {WorkpieceKind::Butt, [](auto& p) { p.rootFaceMm = 8; }, "root_face_mm",
         "expected at most thickness_mm, which is 6 mm"},
        {WorkpieceKind::Butt, [](auto& p) { p.widthMm = 4, p.gapMm = 5; }, "gap_mm", "expected less than width_mm"},
        {WorkpieceKind::Butt, [](auto& p) { p.widthMm = 12, p.bevelDeg = 60; }, "bevel_deg",
         "expected one narrower than"},
        {WorkpieceKind::Butt, [](auto& p) { p.gapMm = 0, p.tackCount = 2; }, "tack_count", "leaves room for tacks"},
        {WorkpieceKind::Butt, [](auto& p) { p.position = static_cast<int>(WeldPosition::f2); }, "position",
         "is 2F, which is none of a butt; expected one of as_it_lies, flat, 1G, 2G, 3G, 4G"},
        {WorkpieceKind::Tee, [](auto& p) { p.tackCount = 20; }, "tack_count", "expected at most the seam's 100 mm"},
        {WorkpieceKind::Tee, [](auto& p) { p.position = static_cast<int>(WeldPosition::g3); }, "position",
         "expected one of as_it_lies, flat, 1F, 2F, 3F, 4F"},
        {WorkpieceKind::Plate, [](auto& p) { p.tackCount = 1; }, "tack_count", "expected 0"},
        {WorkpieceKind::Pipe, [](auto& p) { p.diameterMm = 12; }, "thickness_mm",
         "expected less than half of diameter_mm"},
        {WorkpieceKind::Pipe, [](auto& p) { p.position = static_cast<int>(WeldPosition::f1); }, "position",
         "expected one of as_it_lies, 5G"},
        {WorkpieceKind::Cube, [](auto& p) { p.position = static_cast<int>(WeldPosition::flat); }, "position",
         "expected one of as_it_lies"},
    };
    for (const Case& bad : cases) {
        WorkpieceParameters p;
        p.kind = static_cast<int>(bad.kind);
        CHECK_FALSE(workpieceFault(p));
        bad.spoil(p);
        const auto fault = workpieceFault(p);
        INFO(bad.key << ", " << bad.expectation);
        REQUIRE(fault);
        CHECK(fault->key == bad.key);
        CHECK_THAT(fault->sentence, test::containsText(bad.expectation));
        CHECK_THROWS_WITH(makeWorkpiece(p), test::containsText(bad.key));
    }
}

TEST_CASE("every particle of every workpiece lies inside its space and none twice in one cell") {
    for (int kind = 0; kind < 8; ++kind) {
        WorkpieceParameters p;
        p.kind = kind;
        p.lengthMm = 32;
        p.widthMm = 24;
        p.spacingMm = 0.8F;
        p.bevelDeg = 20;
        if (kind > static_cast<int>(WorkpieceKind::Bridge)) p.tackCount = 2;
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
