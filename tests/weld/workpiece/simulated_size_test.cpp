// Sizes that are no whole number of particles: metal, gauge and pictures have coincident faces within half a spacing of
// the requested ones, and differences are reported.
#include "core/weld/gauge/weld_section.hpp"
#include "core/weld/workpiece/simulated_size.hpp"
#include "tests/support/catch.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

using namespace meltpool;

namespace {

constexpr std::array<float, 4> kSpacingsMm{0.5F, 0.75F, 1.0F, 1.5F};
constexpr int kRows = 6;            ///< rows of particles in a synthetic fillet
constexpr int kHigh = 3, kWide = 8; ///< particles in a bead's height and width
constexpr float kFusion = 1800;     ///< fusion temperature, K
constexpr float kRounding = 1e-3F;  ///< tolerance in spacings

/// Returns a workpiece so small along and across the seam that thousands are made in seconds.
WorkpieceParameters pieceOf(WorkpieceKind kind, float thicknessMm, float spacingMm) {
    WorkpieceParameters p;
    p.kind = static_cast<int>(kind);
    p.thicknessMm = thicknessMm;
    p.spacingMm = spacingMm;
    p.lengthMm = 4 * spacingMm;
    p.widthMm = 2 * (thicknessMm + 10 * spacingMm);
    p.heightMm = thicknessMm + 10 * spacingMm;
    p.gapMm = 2 * spacingMm;
    p.roomAboveMm = 9 * spacingMm;
    p.roomBelowMm = 3 * spacingMm;
    if (kind == WorkpieceKind::Cube) p.lengthMm = thicknessMm + 8 * spacingMm;
    if (kind == WorkpieceKind::Bridge) p.lengthMm = 16 + 4 * spacingMm;
    if (kind == WorkpieceKind::Pipe) {
        p.diameterMm = 2 * thicknessMm + 12;
        p.widthMm = 14 * spacingMm;
        p.gapMm = 0;
    }
    return p;
}

/// Returns the planes around the seeds' cells, mm.
WorkpieceBlock cellsOf(const Workpiece& piece, const std::vector<MetalSeed>& seeds) {
    WorkpieceBlock box{glm::vec3(1e9F), glm::vec3(-1e9F)};
    for (const MetalSeed& seed : seeds) {
        box.low = glm::min(box.low, seed.position - piece.lattice.spacing / 2);
        box.high = glm::max(box.high, seed.position + piece.lattice.spacing / 2);
    }
    return {box.low * 1e3F, box.high * 1e3F};
}

/// Returns the planes of the seeds on one side of a plane, mm.
template <class Side>
WorkpieceBlock partOf(const Workpiece& piece, Side side) {
    std::vector<MetalSeed> part;
    std::copy_if(piece.seeds.begin(), piece.seeds.end(), std::back_inserter(part),
                 [&](const MetalSeed& seed) { return side(seed.position); });
    return cellsOf(piece, part);
}

/// Returns the greatest distance (mm) of the faces at the seam and of those across the plates from their requested
/// places. Faces at a fillet's corner, the origin of torch path and gauge, count tenfold. `free` includes the upper end
/// of a tee's upright plate, which ends with a layer at any height. `middle` is the gap's, mm from the seam.
float farthestFace(const WorkpieceParameters& asked, const Workpiece& piece, bool free = true, float middle = 0) {
    const float t = asked.thicknessMm;
    float most = 0;
    const auto face = [&](float is, float wanted) { most = std::max(most, std::abs(is - wanted)); };
    const auto corner = [&](float is) { face(10 * is, 0); };
    const auto over = [](glm::vec3 at) { return at.y > 0; };
    const auto under = [](glm::vec3 at) { return at.y < 0; };
    const WorkpieceBlock upper = partOf(piece, over), lower = partOf(piece, under);
    switch (static_cast<WorkpieceKind>(asked.kind)) {
    case WorkpieceKind::Tee:
        corner(upper.low.y), corner(upper.high.z), corner(lower.high.y);
        face(lower.low.y, -t), face(upper.low.z, -t);
        if (free) face(upper.high.y, asked.heightMm);
        break;
    case WorkpieceKind::Lap:
        corner(upper.low.y), corner(upper.high.z), corner(lower.high.y);
        face(lower.low.y, -t), face(upper.high.y, t);
        break;
    case WorkpieceKind::Corner:
        corner(upper.low.y), corner(upper.high.z), corner(lower.high.y), corner(lower.low.z);
        face(upper.high.y, t), face(lower.high.z, t), face(lower.low.y, -asked.heightMm);
        break;
    case WorkpieceKind::Butt:
        if (simulatedWorkpiece(asked).gapMm > 0) {
            face(partOf(piece, [](glm::vec3 at) { return at.z < 0; }).high.z, middle - asked.gapMm / 2);
            face(partOf(piece, [](glm::vec3 at) { return at.z > 0; }).low.z, middle + asked.gapMm / 2);
        }
        [[fallthrough]];
    case WorkpieceKind::Plate:
        corner(lower.high.y), face(lower.low.y, -t);
        break;
    case WorkpieceKind::Bridge:
        corner(lower.high.y), face(lower.low.y, -asked.heightMm);
        face(partOf(piece, [](glm::vec3 at) { return std::abs(at.x) < 1e-3F; }).low.y, -t);
        break;
    case WorkpieceKind::Cube:
        face(upper.high.y, asked.lengthMm / 2), face(lower.low.y, -asked.lengthMm / 2);
        break;
    case WorkpieceKind::Pipe:
        break;
    }
    return most;
}

/// True if the boxes that pictures draw contain each particle's cell, and no other space.
bool blocksAreTheMetal(const Workpiece& piece) {
    const double cell = std::pow(static_cast<double>(piece.lattice.spacing), 3);
    double cells = 0;
    for (const WorkpieceBlock& block : piece.blocks) {
        const glm::dvec3 size = block.high - block.low;
        cells += size.x * size.y * size.z / cell;
    }
    if (std::abs(cells - static_cast<double>(piece.seeds.size())) > 0.01 * cells) return false;
    return std::all_of(piece.seeds.begin(), piece.seeds.end(), [&](const MetalSeed& seed) {
        return std::any_of(piece.blocks.begin(), piece.blocks.end(), [&](const WorkpieceBlock& block) {
            return glm::all(glm::greaterThan(seed.position, block.low)) &&
                   glm::all(glm::lessThan(seed.position, block.high));
        });
    });
}

/// Weld metal of one section, mm (z, y), in layers along the seam.
struct Weld {
    Weld(const Workpiece& workpiece, double pipeRadiusMm = 0) : piece(workpiece), radiusMm(pipeRadiusMm) {
        for (const MetalSeed& seed : piece.seeds)
            add(seed.position, 300, seed.phase);
    }

    void add(glm::vec3 at, float kelvin, unsigned phase) {
        values.positions.push_back(vec4(at, 300));
        values.heats.push_back(vec4(0, 0, kelvin, 0));
        values.phases.push_back(phase);
    }

    /// Adds a particle along the whole of a straight seam, or around the upper part of a pipe.
    void add(glm::vec2 mm) {
        const float spacing = piece.lattice.spacing;
        if (radiusMm > 0) {
            const float radius = (static_cast<float>(radiusMm) + mm.y) * 1e-3F;
            for (float along = 0.5F * spacing; along < 8 * spacing; along += spacing) {
                const float angle = along / static_cast<float>(radiusMm * 1e-3);
                add({radius * std::sin(angle), radius * std::cos(angle) - static_cast<float>(radiusMm * 1e-3),
                     mm.x * 1e-3F},
                    2000, PHASE_ALIVE);
            }
            return;
        }
        for (float x = piece.bodyLow.x + spacing / 2; x < piece.bodyHigh.x; x += spacing)
            add({x, mm.y * 1e-3F, mm.x * 1e-3F}, 2000, PHASE_ALIVE);
    }

    Section measure() const {
        const double spacing = static_cast<double>(piece.lattice.spacing);
        SectionCut cut;
        cut.from = radiusMm > 0 ? 2 * spacing : -spacing;
        cut.to = radiusMm > 0 ? 6 * spacing : spacing;
        cut.fusion = static_cast<double>(kFusion);
        std::optional<double> radius;
        if (radiusMm > 0) radius = radiusMm * 1e-3;
        return measureSection(WeldParticles(piece.lattice, values, piece.parts(), radius), cut);
    }

    const Workpiece& piece;
    double radiusMm;
    ParticleValues values;
};

/// Returns a fillet whose straight surface is `rows` and a half spacings from the corner along both faces.
Section filletOf(const Workpiece& piece, float spacingMm, int rows) {
    Weld weld(piece);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < rows - row; ++column)
            weld.add((glm::vec2(column, row) + 0.5F) * spacingMm);
    return weld.measure();
}

/// Returns a bead of kHigh rows of particles over the face, the lowest kWide wide, whose edges follow a circle.
Section beadOf(const WorkpieceParameters& p, const Workpiece& piece, float highMm) {
    Weld weld(piece,
              static_cast<WorkpieceKind>(p.kind) == WorkpieceKind::Pipe ? static_cast<double>(p.diameterMm) / 2 : 0);
    const auto rowOf = [&](float low, int columns, float spacing) {
        for (int column = 0; column < columns; ++column)
            weld.add({(static_cast<float>(column) + 0.5F - static_cast<float>(columns) / 2) * spacing, low});
    };
    for (int row = 0; row < kHigh; ++row)
        rowOf(highMm + (static_cast<float>(row) + 0.5F) * p.spacingMm, kWide - 2 * row, p.spacingMm);
    return weld.measure();
}

template <class Check>
void sweep(Check check) {
#ifdef __SANITIZE_ADDRESS__
    constexpr int kStep = 11; // slow sanitiser builds try fewer sizes of equal code
#else
    constexpr int kStep = 1;
#endif
    for (const float spacing : kSpacingsMm)
        for (int tenths = 15; tenths <= 120; tenths += kStep)
            check(static_cast<float>(tenths) / 10, spacing);
}

constexpr std::array kKinds{WorkpieceKind::Plate, WorkpieceKind::Cube, WorkpieceKind::Bridge, WorkpieceKind::Tee,
                            WorkpieceKind::Lap,   WorkpieceKind::Butt, WorkpieceKind::Corner, WorkpieceKind::Pipe};

} // namespace

TEST_CASE("faces of any thickness lie where metal, pictures and the text say, within half a spacing", "[sizes]") {
    sweep([](float thickness, float spacing) {
        for (const WorkpieceKind kind : kKinds) {
            const WorkpieceParameters asked = pieceOf(kind, thickness, spacing), is = simulatedWorkpiece(asked);
            INFO("workpiece " << static_cast<int>(kind) << ", " << thickness << " mm of " << spacing << " mm");
            const Workpiece piece = makeWorkpiece(asked);
            CHECK(farthestFace(asked, piece) <= (0.5F + kRounding) * spacing);
            CHECK(farthestFace(is, piece, false, gapBesideMiddle(is)) <= kRounding * 10 * spacing);
            if (kind != WorkpieceKind::Pipe) CHECK(blocksAreTheMetal(piece));
            CHECK(simulatedSizes(is).empty());
            const std::vector<SimulatedSize> sizes = simulatedSizes(asked);
            const std::string text = simulatedSizesText(asked);
            CHECK(text.empty() == sizes.empty());
            if (kind == WorkpieceKind::Cube) continue;
            const float layers = thickness / spacing;
            const bool whole = std::abs(layers - std::round(layers)) < kRounding;
            REQUIRE((is.thicknessMm == asked.thicknessMm) == whole);
            CHECK((text.find("Thickness") == std::string::npos) == whole);
        }
    });
}

TEST_CASE("a fillet on plates of any thickness has its legs and its area within half a spacing", "[sizes]") {
    sweep([](float thickness, float spacing) {
        for (const WorkpieceKind kind : {WorkpieceKind::Tee, WorkpieceKind::Lap, WorkpieceKind::Corner}) {
            const WorkpieceParameters asked = pieceOf(kind, thickness, spacing);
            const Workpiece piece = makeWorkpiece(asked);
            const int layers = static_cast<int>(std::lround(simulatedWorkpiece(asked).thicknessMm / spacing));
            // On a plate's edge the weld ends below the next face, and must be thick enough for a layer.
            const int rows = kind == WorkpieceKind::Tee ? kRows : std::min(kRows, layers - 1);
            if (rows < 3) continue;
            INFO("workpiece " << static_cast<int>(kind) << ", " << thickness << " mm of " << spacing << " mm");
            const Section section = filletOf(piece, spacing, rows);
            REQUIRE(section.fillet);
            const double s = static_cast<double>(spacing) * 1e-3, leg = (rows + 0.5) * s;
            CHECK(std::abs(section.fillet->toes[0].place - leg) <= 0.5 * s);
            CHECK(std::abs(section.fillet->toes[1].place - leg) <= 0.5 * s);
            CHECK(std::abs(section.fillet->throat - leg / std::sqrt(2)) <= 0.5 * s);
            CHECK(std::abs(section.fillet->area - 0.5 * leg * leg) <= 0.5 * s * leg * std::sqrt(2));
            CHECK(std::abs(section.deposited - 0.5 * leg * leg) <= 0.5 * s * leg * std::sqrt(2));
            CHECK(section.hole == 0);
        }
    });
}

TEST_CASE("a bead on a workpiece of any thickness has its height, width and area within half a spacing", "[sizes]") {
    sweep([](float thickness, float spacing) {
        for (const WorkpieceKind kind : {WorkpieceKind::Plate, WorkpieceKind::Cube, WorkpieceKind::Bridge,
                                         WorkpieceKind::Butt, WorkpieceKind::Pipe}) {
            WorkpieceParameters asked = pieceOf(kind, thickness, spacing);
            if (kind == WorkpieceKind::Butt) asked.gapMm = 0;
            const Workpiece piece = makeWorkpiece(asked);
            INFO("workpiece " << static_cast<int>(kind) << ", " << thickness << " mm of " << spacing << " mm");
            const float face = kind == WorkpieceKind::Cube ? simulatedWorkpiece(asked).lengthMm / 2 : 0;
            const Section section = beadOf(asked, piece, face);
            REQUIRE(section.bead);
            const double s = static_cast<double>(spacing) * 1e-3;
            CHECK(std::abs(section.bead->height - kHigh * s) <= 0.5 * s);
            CHECK(std::abs(section.bead->toeWidth() - kWide * s) <= (kind == WorkpieceKind::Pipe ? 0.7 : 0.5) * s);
            const double around = kind == WorkpieceKind::Pipe ? 1 + 3e-3 / static_cast<double>(asked.diameterMm) : 1;
            CHECK(std::abs(section.deposited - kHigh * (kWide - kHigh + 1) * s * s * around) <= 0.5 * s * kWide * s);
            CHECK(section.root.height <= 0.5 * s);
        }
    });
}

TEST_CASE("a tee and a lap joint of 4.5 mm plates of 1 mm particles have no slit, and their fillets legs", "[sizes]") {
    for (const WorkpieceKind kind : {WorkpieceKind::Tee, WorkpieceKind::Lap}) {
        INFO(static_cast<int>(kind));
        const Workpiece piece = makeWorkpiece(pieceOf(kind, 4.5F, 1));
        const auto over = partOf(piece, [](glm::vec3 at) { return at.y > 0; });
        const auto under = partOf(piece, [](glm::vec3 at) { return at.y < 0; });
        CHECK(over.low.y == Approx(under.high.y).margin(1e-3));
        const Section section = filletOf(piece, 1, 4);
        REQUIRE(section.fillet);
        CHECK(section.fillet->toes[0].place * 1e3 == Approx(4.5).margin(0.5));
        CHECK(section.fillet->toes[1].place * 1e3 == Approx(4.5).margin(0.5));
    }
}

TEST_CASE("gaps, widths and heights of any size leave the faces at the seam within half a spacing", "[sizes]") {
    for (const float spacing : kSpacingsMm)
        for (int tenths = 0; tenths <= 40; ++tenths) {
            const float more = static_cast<float>(tenths) / 10;
            INFO(more << " mm of " << spacing << " mm");
            for (const WorkpieceKind kind : {WorkpieceKind::Tee, WorkpieceKind::Lap, WorkpieceKind::Corner,
                                             WorkpieceKind::Bridge, WorkpieceKind::Plate}) {
                WorkpieceParameters asked = pieceOf(kind, 6, spacing);
                asked.widthMm += more;
                asked.heightMm += 0.7F * more;
                asked.lengthMm += 0.9F * more;
                const Workpiece piece = makeWorkpiece(asked);
                CHECK(farthestFace(asked, piece) <= (0.5F + kRounding) * spacing);
                CHECK(blocksAreTheMetal(piece));
            }
            for (const float width : {20.0F, 20.3F, 21.0F, 21.5F, 30.75F}) {
                WorkpieceParameters asked = pieceOf(WorkpieceKind::Butt, 6, spacing);
                asked.gapMm = more;
                asked.widthMm = width;
                INFO(width << " mm wide");
                const Workpiece piece = makeWorkpiece(asked);
                CHECK(farthestFace(asked, piece) <= (0.5F + kRounding) * spacing);
                CHECK(blocksAreTheMetal(piece));
                const float gap = simulatedWorkpiece(asked).gapMm;
                CHECK((simulatedSizesText(asked).find("Gap") == std::string::npos) == (gap == more));
                if (gap <= 0) continue;
                const auto low = partOf(piece, [](glm::vec3 at) { return at.z < 0; });
                const auto high = partOf(piece, [](glm::vec3 at) { return at.z > 0; });
                CHECK(high.low.z - low.high.z == Approx(gap).margin(kRounding));
            }
        }
}

TEST_CASE("a pipe of any wall has the metal of the wall that is said", "[sizes]") {
    sweep([](float thickness, float spacing) {
        const WorkpieceParameters asked = pieceOf(WorkpieceKind::Pipe, thickness, spacing);
        const WorkpieceParameters is = simulatedWorkpiece(asked);
        const Workpiece pipe = makeWorkpiece(asked);
        INFO(thickness << " mm of " << spacing << " mm");
        const double outer = static_cast<double>(is.diameterMm) / 2, wall = static_cast<double>(is.thicknessMm);
        const double area = std::numbers::pi * wall * (2 * outer - wall);
        const double cell = static_cast<double>(spacing) * static_cast<double>(spacing);
        const double found = static_cast<double>(pipe.seeds.size()) / 14 * cell; // 14 layers across
        // The steps of round faces are within 0.15 spacings on average.
        const double faces = 2 * std::numbers::pi * (2 * outer - wall);
        CHECK(found == Approx(area).margin(0.15 * static_cast<double>(spacing) * faces));
        REQUIRE(pipe.pipe);
        CHECK(static_cast<double>(pipe.pipe->outer - pipe.pipe->inner) * 1e3 == Approx(wall));
        CHECK(std::abs(is.thicknessMm - thickness) <= (0.5F + kRounding) * spacing);
    });
}

TEST_CASE("whole sizes stay to the last bit, others become the nearest whole one, and a sentence says which",
          "[sizes]") {
    WorkpieceParameters tee;
    tee.kind = static_cast<int>(WorkpieceKind::Tee);
    tee.thicknessMm = 6;
    CHECK(simulatedSizesText(tee).empty());
    tee.spacingMm = 0.75F;
    tee.widthMm = 36;
    CHECK(simulatedWorkpiece(tee).thicknessMm == tee.thicknessMm);
    CHECK(simulatedSizesText(tee).empty());
    tee.spacingMm = 1;
    tee.thicknessMm = 4.5F;
    CHECK(simulatedWorkpiece(tee).thicknessMm == 5);
    CHECK(simulatedSizesText(tee) == "Particles of 1 mm make whole layers only. Thickness is 5 mm instead of 4.5 mm. "
                                     "Particles of 0.9 mm keep the thickness.");
    tee.spacingMm = 0.9F;
    CHECK(simulatedWorkpiece(tee).thicknessMm == tee.thicknessMm);
    tee.widthMm = 44;
    CHECK(simulatedSizesText(tee) == "Particles of 0.9 mm make whole layers only. Width is 43.2 mm instead of 44 mm.");
    tee.widthMm = 36;
    tee.spacingMm = 1;
    tee.thicknessMm = 4.4F;
    CHECK(simulatedWorkpiece(tee).thicknessMm == 4);
    tee.thicknessMm = 1;
    tee.spacingMm = 2;
    tee.widthMm = 40;
    CHECK(simulatedWorkpiece(tee).thicknessMm == 2); // at least one layer
    WorkpieceParameters butt;
    butt.kind = static_cast<int>(WorkpieceKind::Butt);
    butt.gapMm = 0.4F;
    CHECK(simulatedWorkpiece(butt).gapMm == 0);
    CHECK(simulatedSizesText(butt) == "Particles of 1 mm make whole layers only. Gap is 0 mm instead of 0.4 mm.");
    butt.gapMm = 1; // with plates of 24.5 mm: the one on -z has the odd layer
    CHECK(simulatedSizes(butt).empty());
    CHECK(gapBesideMiddle(butt) == 0.5F);
    butt.widthMm = 51;
    CHECK(gapBesideMiddle(butt) == 0);
    butt.rootFaceMm = butt.thicknessMm = 4.5F; // square edges stay square
    CHECK(simulatedWorkpiece(butt).rootFaceMm == 5);
}

TEST_CASE("a size that only whole layers make impossible is refused with the layers' sizes", "[sizes]") {
    WorkpieceParameters pipe;
    pipe.kind = static_cast<int>(WorkpieceKind::Pipe);
    pipe.diameterMm = 10;
    pipe.thicknessMm = 4.6F;
    pipe.gapMm = 0;
    const auto fault = workpieceFault(pipe);
    REQUIRE(fault);
    CHECK(fault->key == "thickness_mm");
    CHECK(fault->sentence == "is 5 mm; expected less than half of diameter_mm, which is 10 mm. Particles of 1 mm make "
                             "whole layers only. Thickness is 5 mm instead of 4.6 mm. Particles of 0.92 mm keep the "
                             "thickness.");
}
