// Sections of metal with known zones: on plates and in corners, in part off the lattice, empty, and outside the metal.
#include "core/base/error.hpp"
#include "core/weld/gauge/weld_section.hpp"
#include "core/weld/gauge/weld_stations.hpp"
#include "core/weld/workpiece/workpiece.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>

using namespace meltpool;

namespace {

constexpr float kSpacing = 1e-3F;

Material steel() {
    return readMaterial(test::testFolder().parent_path() / "app" / "data" / "materials" / "s235.toml");
}

/// A workpiece with a field of highest temperatures.
struct Heated {
    Heated(WorkpieceKind kind, const std::function<float(glm::vec3)>& peak) {
        WorkpieceParameters p;
        p.kind = static_cast<int>(kind);
        p.lengthMm = 16;
        p.widthMm = 24;
        p.thicknessMm = 6;
        p.heightMm = 12;
        piece = makeWorkpiece(p);
        for (MetalSeed& seed : piece.seeds)
            seed.temperature = peak(seed.position);
    }

    MetalState state(const std::vector<MetalSeed>& more = {}) const {
        MetalState made(piece.lattice, HeatTable(steel()), 7850, piece.seeds.size() + more.size());
        made.add(piece.seeds);
        made.add(more);
        return made;
    }

    Workpiece piece;
};

/// Returns a field of 1800 K at `radius` (m) from the seam's line, 1e5 K less each metre outwards.
std::function<float(glm::vec3)> coneOf(float radius) {
    return [radius](glm::vec3 p) { return 1800 + 1e5F * (radius - std::hypot(p.y, p.z)); };
}

SectionCut cutOf(double from, double to) {
    SectionCut cut;
    cut.from = from;
    cut.to = to;
    cut.fusion = 1800;
    cut.heatAffected = 1600;
    return cut;
}

} // namespace

TEST_CASE("a section is measured from the highest temperatures, on the lattice or off it", "[gauge]") {
    test::context();
    const MetalLattice lattice = MetalLattice::covering({0, -8 * kSpacing, -12 * kSpacing},
                                                        {8 * kSpacing, 4 * kSpacing, 12 * kSpacing}, kSpacing);
    auto seeds = latticeSeeds(lattice, lattice.low, {8 * kSpacing, 0, 12 * kSpacing}, 300);
    // Peak temperatures fall linearly from 2000 K at the seam: 100 K each millimetre across, 200 K each millimetre
    // down.
    for (MetalSeed& seed : seeds)
        seed.temperature = 2000 - 1e5F * std::abs(seed.position.z) + 2e5F * seed.position.y;
    const std::vector<MetalSeed> plate = seeds;
    REQUIRE(plate.size() == 8 * 8 * 24);
    for (int i = 0; i < 8; ++i) // a bead of three rows with one row on top
        for (int j = -1; j <= 2; ++j) {
            const float x = (static_cast<float>(i) + 0.5F) * kSpacing;
            const glm::vec3 place = j < 2 ? glm::vec3(x, 0.5F * kSpacing, static_cast<float>(j) * kSpacing)
                                          : glm::vec3(x, 1.5F * kSpacing, 0);
            seeds.push_back({place, 2000, PHASE_ALIVE, glm::vec3(0)});
        }
    MetalState state(lattice, HeatTable(steel()), 7850, seeds.size());
    state.add(seeds);
    SectionCut cut = cutOf(0, 8e-3);
    cut.fusion = 1500;
    cut.heatAffected = 1000;
    const Section section = measureSection(state, plate, cut);
    CHECK(section.layers == 8);
    CHECK(section.fusion.width * 1e3 == Approx(2 * (500.0 - 100) / 100).margin(0.05)); // depth of half a millimetre
    CHECK(section.fusion.depth * 1e3 == Approx(450.0 / 200).margin(0.05)); // half a millimetre from the seam
    CHECK(section.heatAffected->depth * 1e3 == Approx(950.0 / 200).margin(0.05));
    CHECK(section.deposited * 1e6 == Approx(4));
    // A bead three wide with one particle on top has a rounded crown two rows high.
    REQUIRE(section.bead);
    CHECK(section.bead->height * 1e3 == Approx(1.75).margin(0.15));
    CHECK(section.bead->toeWidth() * 1e3 == Approx(2.6).margin(0.5)); // of the rounded line, between one and three
    CHECK(section.fusion.box.height == Approx(section.bead->height));
    REQUIRE(section.fusion.stretch);
    CHECK(section.fusion.stretch->length() == Approx(section.fusion.width));
    CHECK(0.5 * (section.fusion.stretch->low + section.fusion.stretch->high) == Approx(0).margin(1e-5));
    CHECK_FALSE(section.fillet);
    CHECK_FALSE(section.rootFusion);
    CHECK(section.fusion.box.depth == Approx(section.fusion.depth));
    CHECK(section.fusion.box.area == Approx(section.fusion.area + section.deposited));
    // The molten part is now off the lattice.
    auto phases = state.phase.read<uint>(state.particles());
    for (size_t i = 0; i < plate.size(); ++i)
        if (seeds[i].temperature > 1500) phases[i] &= ~PHASE_LATTICE;
    state.phase.write(std::span<const uint>(phases));
    const Section gone = measureSection(state, plate, cut);
    CHECK(gone.fusion.width == Approx(section.fusion.width).margin(1e-5));
    CHECK(gone.fusion.depth == Approx(section.fusion.depth).margin(1e-5));
    // Metal that fell off without melting is not part of the fusion zone.
    for (size_t i = 0; i < plate.size(); ++i)
        if (seeds[i].temperature < 1500) phases[i] &= ~PHASE_LATTICE;
    state.phase.write(std::span<const uint>(phases));
    CHECK(measureSection(state, plate, cut).fusion.depth == Approx(section.fusion.depth).margin(1e-5));
}

TEST_CASE("a tee's section follows both plates and has no height over one level", "[gauge]") {
    test::context();
    const Heated tee(WorkpieceKind::Tee, coneOf(3.3e-3F));
    std::vector<MetalSeed> fillet; // a staircase of ten rows along the corner
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 16; ++j)
            if (j / 4 + j % 4 < 4)
                fillet.push_back(
                    {{(static_cast<float>(i) - 7.5F) * kSpacing, (0.5F + static_cast<float>(j / 4)) * kSpacing,
                      (0.5F + static_cast<float>(j % 4)) * kSpacing},
                     1900,
                     PHASE_ALIVE,
                     glm::vec3(0)});
    const Section section = measureSection(tee.state(fillet), tee.piece.seeds, cutOf(-2.5e-3, 2.5e-3));
    CHECK(section.layers == 5);
    CHECK_FALSE(section.bead.has_value());
    CHECK(section.deposited * 1e6 == Approx(10));
    REQUIRE(section.fillet);
    CHECK(section.fillet->toes[0].place * 1e3 == Approx(4.5).margin(0.3)); // mean line of the staircase
    CHECK(section.fillet->toes[1].place * 1e3 == Approx(4.5).margin(0.3));
    CHECK(section.fillet->throat * 1e3 == Approx(4.5 / std::sqrt(2.0)).margin(0.3));
    CHECK(section.fillet->area * 1e6 == Approx(10).margin(1));
    REQUIRE(section.rootFusion);
    CHECK(*section.rootFusion * 1e3 == Approx(std::sqrt(3.3 * 3.3 - 0.25)).margin(0.06));
    const double leg = std::sqrt(3.3 * 3.3 - 0.25);
    CHECK(section.fusion.width * 1e3 == Approx(2 * 3.3).margin(0.25));
    CHECK(section.fusion.depth * 1e3 == Approx(3.3).margin(0.06));
    CHECK(section.fusion.area * 1e6 == Approx(0.75 * 3.14159 * 3.3 * 3.3).epsilon(0.04));
    CHECK(section.fusion.box.height == Approx(section.fillet->toes[1].place)); // above the fused zone
    CHECK(section.fusion.box.depth * 1e3 == Approx(leg).margin(0.05));
    REQUIRE(section.heatAffected);
    CHECK(section.heatAffected->depth * 1e3 == Approx(5.3).margin(0.06));
    CHECK(section.heatAffected->width > section.fusion.width);
}

TEST_CASE("a toe has no angle against a lap's upper edge that the weld covers", "[gauge]") {
    test::context();
    const Heated lap(WorkpieceKind::Lap, coneOf(3.3e-3F));
    // A staircase in the corner, so many rows high.
    const auto stationWith = [&](int rows) {
        std::vector<MetalSeed> fillet;
        for (int i = 0; i < 16; ++i)
            for (int row = 0; row < rows; ++row)
                for (int column = 0; column < rows - row; ++column)
                    fillet.push_back(
                        {{(static_cast<float>(i) - 7.5F) * kSpacing, (0.5F + static_cast<float>(row)) * kSpacing,
                          (0.5F + static_cast<float>(column)) * kSpacing},
                         1900,
                         PHASE_ALIVE,
                         glm::vec3(0)});
        return stationOf(measureSection(lap.state(fillet), lap.piece.seeds, cutOf(-2.5e-3, 2.5e-3)), WeldKind::fillet,
                         0);
    };
    const WeldStation low = stationWith(3), covering = stationWith(8);
    CHECK(low.edgeAngle2);
    CHECK_FALSE(covering.edgeAngle2);
    CHECK(covering.edgeAngle1);
    REQUIRE((low.overlap2 && covering.overlap2));
    CHECK(*covering.overlap2 < *covering.leg2); // no overlap beyond the edge
}

TEST_CASE("every kind of workpiece has a section, and only level ones have a height", "[gauge]") {
    test::context();
    for (const auto kind : {WorkpieceKind::Plate, WorkpieceKind::Cube, WorkpieceKind::Bridge, WorkpieceKind::Tee,
                            WorkpieceKind::Lap, WorkpieceKind::Butt}) {
        INFO(static_cast<int>(kind));
        const Heated heated(kind, [](glm::vec3 p) { return p.x > -2e-3F && p.x < 2e-3F ? 2000.0F : 300.0F; });
        const MetalState state = heated.state();
        const Section section = measureSection(state, heated.piece.seeds, cutOf(-1e-3, 1e-3));
        CHECK(section.layers == 2);
        CHECK(section.bead.has_value() == (kind != WorkpieceKind::Tee && kind != WorkpieceKind::Lap));
        CHECK(section.deposited == 0);
        size_t layer = 0;
        for (const MetalSeed& seed : heated.piece.seeds)
            layer += seed.position.x > 0 && seed.position.x < kSpacing;
        CHECK(section.fusion.area * 1e6 == Approx(layer)); // the whole layer
        CHECK(section.fusion.depth > 0);
        CHECK(middleOfWeld(state, heated.piece.seeds, 1800) == Approx(0).margin(1e-9));
    }
}

TEST_CASE("a cut beside the metal is empty, one that ends beside it counts the layers it meets", "[gauge]") {
    test::context();
    const Heated plate(WorkpieceKind::Plate, coneOf(3));
    const MetalState state = plate.state();
    for (const double at : {-0.5, 0.012, 1e6}) {
        const WeldSection none = cutWeld(state, plate.piece.seeds, cutOf(at - 2e-3, at + 2e-3));
        CHECK(none.figures.layers == 0);
        CHECK(none.figures.fusion.width == 0);
        CHECK(none.figures.deposited == 0);
        CHECK_FALSE(none.figures.bead.has_value());
        CHECK_FALSE(none.figures.fillet.has_value());
        REQUIRE(none.figures.heatAffected);
        CHECK(none.figures.heatAffected->area == 0);
        CHECK(none.map.sums.empty());
    }
    const Section end = measureSection(state, plate.piece.seeds, cutOf(6e-3, 12e-3));
    CHECK(end.layers == 2);
    CHECK(end.fusion.area == Approx(24e-3 * 6e-3));
    CHECK(end.deposited == 0);
}

TEST_CASE("the middle of a weld is the middle of what was molten, or of the workpiece", "[gauge]") {
    test::context();
    const Heated early(WorkpieceKind::Plate, [](glm::vec3 p) { return p.x < -4e-3F ? 1900.0F : 300.0F; });
    CHECK(middleOfWeld(early.state(), early.piece.seeds, 1800) == Approx(-6e-3));
    const Heated cold(WorkpieceKind::Cube, [](glm::vec3) { return 300.0F; });
    CHECK(middleOfWeld(cold.state(), cold.piece.seeds, 1800) == Approx(0).margin(1e-9));
}

TEST_CASE("a section of too few particles is refused", "[gauge]") {
    test::context();
    const Heated plate(WorkpieceKind::Plate, coneOf(3));
    MetalState state(plate.piece.lattice, HeatTable(steel()), 7850, 100);
    state.add(std::span(plate.piece.seeds).first(100));
    CHECK_THROWS_AS(measureSection(state, plate.piece.seeds, cutOf(0, 1e-3)), RuntimeFault);
}

TEST_CASE("steel is asked for its heat-affected zone, solder is not", "[gauge]") {
    const SectionCut cut = sectionCut(steel(), -1e-3, 3e-3);
    CHECK(cut.at() == Approx(1e-3));
    CHECK(cut.heatAffected == kSteelTransformation);
    CHECK(cut.fusion == Approx(0.5 * (steel().solidus + steel().liquidus)));
    Material solder = steel();
    solder.solidus = 456;
    solder.liquidus = 463;
    CHECK_FALSE(sectionCut(solder, 0, 1).heatAffected.has_value());
}

TEST_CASE("a section has the bead's shape and where it lies over cold plate", "[gauge]") {
    test::context();
    // The bead is an arc of 80 degrees and 3 mm height over a plate that is fused from -2 to 3 mm.
    const double angle = 80 * 3.14159265358979 / 180, radius = 3 / (1 - std::cos(angle)),
                 half = radius * std::sin(angle);
    const auto hot = [](glm::vec3 p) { return p.y > -1.2e-3F && p.z > -2e-3F && p.z < 3e-3F ? 1900.0F : 700.0F; };
    const Heated plate(WorkpieceKind::Plate, hot);
    std::vector<MetalSeed> bead;
    for (int layer = -8; layer < 8; ++layer)
        for (int row = 0; row < 3; ++row) {
            const double up = 0.5 + row + radius * std::cos(angle), reach = std::sqrt(radius * radius - up * up);
            const double count = std::floor(2 * reach + (layer + 8.5) / 16);
            for (double i = 0.5; i < count; ++i) {
                const double across = reach * (2 * i / count - 1);
                bead.push_back({glm::vec3(layer + 0.5, row + 0.5, across) * kSpacing, 2000, PHASE_ALIVE, glm::vec3(0)});
            }
        }
    const Section section = measureSection(plate.state(bead), plate.piece.seeds, cutOf(-8e-3, 8e-3));
    CHECK(section.layers == 16);
    REQUIRE(section.bead);
    CHECK(section.bead->height * 1e3 == Approx(3).margin(0.15));
    CHECK(section.bead->toeWidth() * 1e3 == Approx(2 * half).margin(0.36));
    REQUIRE(section.bead->toes);
    for (const WeldToe& toe : *section.bead->toes)
        CHECK(toe.angle == Approx(angle).margin(0.12));
    REQUIRE(section.fusion.stretch);
    CHECK(section.fusion.stretch->low * 1e3 == Approx(-2).margin(0.5));
    CHECK(section.fusion.stretch->high * 1e3 == Approx(3).margin(0.5));
    const auto overlap = section.bead->overlap(section.fusion.stretch);
    CHECK(overlap[0] * 1e3 == Approx(half - 2).margin(0.6));
    CHECK(overlap[1] * 1e3 == Approx(half - 3).margin(0.6));
    CHECK(section.deposited * 1e6 ==
          Approx(radius * radius * (angle - std::sin(angle) * std::cos(angle))).epsilon(0.05));
    CHECK(section.bead->reinforcement == Approx(section.deposited).epsilon(0.08));
}

TEST_CASE("several cuts through one metal are those that are made one by one", "[gauge]") {
    test::context();
    const Heated tee(WorkpieceKind::Tee, coneOf(3.3e-3F));
    const MetalState state = tee.state();
    std::vector<SectionCut> cuts;
    for (const double at : {-7e-3, -2e-3, 3.5e-3, 0.5})
        cuts.push_back(cutOf(at - 1e-3, at + 1e-3));
    const std::vector<Section> together = measureSections(state, tee.piece.seeds, cuts);
    REQUIRE(together.size() == cuts.size());
    for (size_t i = 0; i < cuts.size(); ++i) {
        const Section alone = measureSection(state, tee.piece.seeds, cuts[i]);
        CHECK(together[i].layers == alone.layers);
        CHECK(together[i].fusion.area == alone.fusion.area);
        CHECK(together[i].fusion.depth == alone.fusion.depth);
        CHECK(together[i].rootFusion == alone.rootFusion);
    }
    CHECK(together[0].layers == 2);
    CHECK(together[3].layers == 0);
    const auto welded = weldedStretch(WeldParticles(state, tee.piece.seeds), 1800);
    REQUIRE(welded);
    CHECK(welded->low == Approx(-7.5e-3));
    CHECK(welded->high == Approx(7.5e-3));
    CHECK_FALSE(weldedStretch(WeldParticles(state, tee.piece.seeds), 5000));
}

TEST_CASE("a corner's section says which stretch of each face is fused", "[gauge]") {
    test::context();
    const Heated tee(WorkpieceKind::Tee, coneOf(3.3e-3F));
    const Section fused = measureSection(tee.state(), tee.piece.seeds, cutOf(-2e-3, 2e-3));
    CHECK(fused.rootFused == 1);
    CHECK(fused.facesFused == Approx(1));
    REQUIRE(fused.fusedFaces);
    for (const FaceStretch& face : *fused.fusedFaces) {
        CHECK(face.low == 0);
        CHECK(face.high * 1e3 == Approx(3.3).margin(0.15));
    }
    // Only the base plate is heated, 4 mm from the corner.
    const Heated beside(WorkpieceKind::Tee,
                        [](glm::vec3 p) { return 1800 + 1e5F * (2e-3F - std::hypot(p.y, p.z - 4e-3F)); });
    const Section cold = measureSection(beside.state(), beside.piece.seeds, cutOf(-2e-3, 2e-3));
    CHECK(cold.rootFused == 0);
    CHECK(cold.facesFused == 0);
    REQUIRE(cold.fusedFaces);
    CHECK((*cold.fusedFaces)[0].low * 1e3 == Approx(2).margin(0.25));
    CHECK((*cold.fusedFaces)[0].high * 1e3 == Approx(6).margin(0.25));
    CHECK((*cold.fusedFaces)[1].length() == 0);
}

TEST_CASE("the face of a plate is fused as far as the heat reached at the face itself", "[gauge]") {
    test::context();
    const Heated plate(WorkpieceKind::Plate, coneOf(3.3e-3F));
    const Section section = measureSection(plate.state(), plate.piece.seeds, cutOf(-2e-3, 2e-3));
    REQUIRE(section.fusedTop);
    CHECK(section.fusedTop->low * 1e3 == Approx(-3.3).margin(0.15));
    CHECK(section.fusedTop->high * 1e3 == Approx(3.3).margin(0.15));
    const Heated cold(WorkpieceKind::Plate, [](glm::vec3) { return 300.0F; });
    CHECK_FALSE(measureSection(cold.state(), cold.piece.seeds, cutOf(-2e-3, 2e-3)).fusedTop);
}

TEST_CASE("a butt's section says how far its edges are fused, and where it is open", "[gauge]") {
    test::context();
    WorkpieceParameters p;
    p.kind = static_cast<int>(WorkpieceKind::Butt);
    p.lengthMm = 16;
    p.widthMm = 24;
    p.thicknessMm = 6;
    p.gapMm = 2;
    Heated butt(WorkpieceKind::Butt, coneOf(1));
    butt.piece = makeWorkpiece(p);
    for (MetalSeed& seed : butt.piece.seeds) // the edge on -z is hot down to 4.5 mm, the other one down to 2.5 mm
        seed.temperature = seed.position.y > (seed.position.z < 0 ? -4.5e-3F : -2.5e-3F) ? 1900.0F : 1700.0F;
    std::vector<MetalSeed> metal; // metal that fills the gap at x < 0 and hangs two rows under and over it
    for (int i = 0; i < 8; ++i)
        for (int j = -8; j < 2; ++j)
            for (int k = -1; k < 1; ++k)
                metal.push_back({(glm::vec3(i - 8, j, k) + 0.5F) * kSpacing, 1900, PHASE_ALIVE, glm::vec3(0)});
    const MetalState state = butt.state(metal);
    const Section filled = measureSection(state, butt.piece.seeds, cutOf(-6e-3, -2e-3));
    REQUIRE(filled.unfusedEdges);
    CHECK((*filled.unfusedEdges)[0] * 1e3 == Approx(1.5).margin(0.51));
    CHECK((*filled.unfusedEdges)[1] * 1e3 == Approx(3.5).margin(0.51));
    CHECK(filled.rootFused == 0);
    CHECK(filled.facesFused == 1);
    CHECK(filled.hole == 0);
    CHECK(filled.root.height * 1e3 == Approx(2).margin(0.5));
    CHECK(filled.rootConcavity == 0);
    const Section open = measureSection(state, butt.piece.seeds, cutOf(2e-3, 6e-3));
    CHECK(open.hole * 1e3 == Approx(2));
    CHECK(open.root.height == 0);
    // Both edges are fused all through.
    for (MetalSeed& seed : butt.piece.seeds)
        seed.temperature = 1900;
    const Section through = measureSection(butt.state(metal), butt.piece.seeds, cutOf(-6e-3, -2e-3));
    CHECK((*through.unfusedEdges)[0] == 0);
    CHECK(through.rootFused == 1);
}

TEST_CASE("a hole is told by its width, a hollow by its depth", "[gauge]") {
    test::context();
    const Heated plate(WorkpieceKind::Plate, coneOf(8e-3F));
    MetalState state = plate.state();
    auto phases = state.phase.read<uint>(state.particles());
    for (size_t i = 0; i < plate.piece.seeds.size(); ++i) {
        const glm::vec3 at = plate.piece.seeds[i].position;
        const bool hole = at.x < -2e-3F && at.x > -5e-3F && at.z > -1e-3F && at.z < 2e-3F;
        const bool hollow = at.x > 0 && std::abs(at.z) < 3e-3F && at.y > -2e-3F;
        if (hole || hollow) phases[i] = 0;
    }
    state.phase.write(std::span<const uint>(phases));
    const Section hole = measureSection(state, plate.piece.seeds, cutOf(-5e-3, -2e-3));
    CHECK(hole.hole * 1e3 == Approx(3));
    const Section hollow = measureSection(state, plate.piece.seeds, cutOf(2e-3, 6e-3));
    CHECK(hollow.hole == 0);
    CHECK(hollow.underfill * 1e3 == Approx(2).margin(0.5));
    const Section sound = measureSection(state, plate.piece.seeds, cutOf(-8e-3, -6e-3));
    CHECK(sound.hole == 0);
    CHECK(sound.underfill == Approx(0).margin(1e-6));
    CHECK(sound.root.height == 0);
}

TEST_CASE("the cooling time is that of the molten metal, once it has cooled", "[gauge]") {
    test::context();
    const Heated plate(WorkpieceKind::Plate, coneOf(3.3e-3F));
    MetalState state = plate.state();
    CHECK_FALSE(measureSection(state, plate.piece.seeds, cutOf(-2e-3, 2e-3)).coolingTime); // the metal is still hot
    auto places = state.position.read<vec4>(state.particles());
    auto heats = state.heat.read<vec4>(state.particles());
    for (size_t i = 0; i < places.size(); ++i) {
        places[i].w = 400;
        heats[i].w = heats[i].z >= 1800 ? 6.5F : 100.0F;
    }
    state.position.write(std::span<const vec4>(places));
    state.heat.write(std::span<const vec4>(heats));
    const Section cooled = measureSection(state, plate.piece.seeds, cutOf(-2e-3, 2e-3));
    REQUIRE(cooled.coolingTime);
    CHECK(*cooled.coolingTime == Approx(6.5));
    SectionCut solder = cutOf(-2e-3, 2e-3);
    solder.heatAffected.reset();
    CHECK_FALSE(measureSection(state, plate.piece.seeds, solder).coolingTime);
}
