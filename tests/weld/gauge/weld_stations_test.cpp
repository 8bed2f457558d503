// Stations of a weld: figures from sections, means and extremes, straightness, the table, and complete welds of known
// shape.
#include "core/weld/gauge/weld_stations.hpp"

#include "core/base/text.hpp"
#include "core/weld/gauge/weld_figures.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

using namespace meltpool;

namespace {

constexpr double kMm = 1e-3;

Material steel() {
    return readMaterial(test::testFolder().parent_path() / "app" / "data" / "materials" / "s235.toml");
}

/// Returns a fillet's section: legs 6 and 5 mm, faces fused to 5.5 and 4 mm, the root by 1 mm.
Section filletSection() {
    Section section;
    section.layers = 4;
    section.fusion.width = 9.5 * kMm;
    section.fusion.depth = 1.5 * kMm;
    section.heatAffected.emplace().width = 13.5 * kMm;
    FilletShape& fillet = section.fillet.emplace();
    fillet.toes = {{{6 * kMm, 0.9}, {5 * kMm, 0.8}}};
    fillet.throat = 4.2 * kMm;
    fillet.convexity = 0.3 * kMm;
    section.fusedFaces = {{{0, 5.5 * kMm}, {0, 4 * kMm}}};
    section.rootFusion = 1 * kMm;
    section.rootFused = 1;
    section.facesFused = 1;
    section.undercut = {0.1 * kMm, 0.4 * kMm};
    section.hole = 0;
    section.coolingTime = 8;
    return section;
}

WeldStation at(double placeMm, double middleMm) {
    WeldStation station;
    station.place = placeMm * kMm;
    station.middle = middleMm * kMm;
    station.toeWidth = placeMm * kMm;
    return station;
}

using Inside = std::function<bool(glm::vec2)>; ///< shape as a function of a place (z, y) in mm

/// Returns a joint of 4 mm plates and particles of 0.5 mm.
WorkpieceParameters jointOf(WorkpieceKind kind) {
    WorkpieceParameters p;
    p.kind = static_cast<int>(kind);
    p.lengthMm = 60;
    p.widthMm = 24;
    p.thicknessMm = 4;
    p.heightMm = 14;
    p.gapMm = 2;
    p.roomAboveMm = 6;
    p.spacingMm = 0.5F;
    return p;
}

/// Measures a joint welded from x = -20 to 20 mm with metal of this section; its plates are fused where `fused` is
/// true.
WeldMeasures measureJoint(const WorkpieceParameters& p, const Inside& metal, const Inside& fused) {
    Workpiece piece = makeWorkpiece(p);
    const auto place = [](glm::vec3 at) { return glm::vec2(at.z, at.y) * 1e3F; };
    for (MetalSeed& seed : piece.seeds)
        if (std::abs(seed.position.x) < 20e-3F && fused(place(seed.position))) seed.temperature = 1900;
    std::set<size_t> taken;
    for (const MetalSeed& seed : piece.seeds)
        taken.insert(piece.lattice.index(piece.lattice.cellAt(seed.position)));
    // The section shifts a little from layer to layer, so that four layers resolve more than whole cells.
    const auto moved = [&](glm::vec3 at) {
        const int layer = piece.lattice.cellAt(at).x % 4;
        return place(at) + glm::vec2(0.125F * (static_cast<float>(layer) - 1.5F), 0);
    };
    std::vector<MetalSeed> weld;
    for (const MetalSeed& seed :
         latticeSeeds(piece.lattice, {-20e-3F, piece.low.y, piece.low.z}, {20e-3F, piece.high.y, piece.high.z}, 2000))
        if (!taken.contains(piece.lattice.index(piece.lattice.cellAt(seed.position))) && metal(moved(seed.position)))
            weld.push_back({seed.position, 2000, PHASE_ALIVE, glm::vec3(0)});
    MetalState state(piece.lattice, HeatTable(steel()), 7850, piece.seeds.size() + weld.size());
    state.add(piece.seeds);
    state.add(weld);
    return measureWeld(state, piece.parts(), steel(), weldKindOf(p));
}

/// A bead of half circles of metal on a plate, of radius `radius` (mm) along x from -20 to 20 mm, with a sideways swing
/// of `swing` (mm); the plate is fused 2 mm deep under it.
struct PlateWeld {
    static constexpr float kSpacing = 0.5F;

    explicit PlateWeld(float radius, float swing = 0) {
        WorkpieceParameters p;
        p.lengthMm = 60;
        p.widthMm = 24;
        p.thicknessMm = 4;
        p.roomAboveMm = 6;
        p.spacingMm = kSpacing;
        piece = makeWorkpiece(p);
        const auto middle = [=](float x) { return swing * std::sin(x / 3e-3F) * 1e-3F; };
        for (MetalSeed& seed : piece.seeds) {
            const glm::vec3 at = seed.position;
            const float across = at.z - middle(at.x), half = (radius + 0.4F) * 1e-3F;
            if (std::abs(at.x) < 20e-3F && std::abs(across) < half && at.y > -2e-3F) seed.temperature = 1900;
        }
        const float step = kSpacing * 1e-3F;
        const auto reach = static_cast<int>(radius / kSpacing) + 1;
        for (int i = -40; i < 40; ++i)
            for (int row = 0; row < reach; ++row)
                for (int column = -reach; column < reach; ++column) {
                    const glm::vec3 at((static_cast<float>(i) + 0.5F) * step, (static_cast<float>(row) + 0.5F) * step,
                                       (static_cast<float>(column) + 0.5F) * step);
                    if (std::hypot(at.y, at.z) > radius * 1e-3F) continue;
                    const float moved = std::round(middle(at.x) / step) * step;
                    metal.push_back({at + glm::vec3(0, 0, moved), 2000, PHASE_ALIVE, glm::vec3(0)});
                }
    }

    WeldMeasures measure(const StationSettings& settings = {}) const {
        MetalState state(piece.lattice, HeatTable(steel()), 7850, piece.seeds.size() + metal.size());
        state.add(piece.seeds);
        state.add(metal);
        return measureWeld(state, piece.seeds, steel(), WeldKind::bead, settings);
    }

    Workpiece piece;
    std::vector<MetalSeed> metal;
};

} // namespace

TEST_CASE("a fillet's station has the figures of its section", "[stations]") {
    const WeldStation s = stationOf(filletSection(), WeldKind::fillet, 3 * kMm);
    CHECK(s.place == 3 * kMm);
    CHECK(*s.leg1 == Approx(6 * kMm));
    CHECK(*s.leg2 == Approx(5 * kMm));
    CHECK(*s.toeWidth == Approx(std::hypot(6, 5) * kMm));
    CHECK(*s.throat == Approx(4.2 * kMm));
    CHECK(*s.overlap1 == Approx(0.5 * kMm));
    CHECK(*s.overlap2 == Approx(1 * kMm));
    CHECK(*s.lackOfFusion == Approx(-1 * kMm)); // fused into the joint
    CHECK(*s.facesFused == 1);
    CHECK(*s.middle == Approx(1 * kMm / (2 * std::numbers::sqrt2)));
    CHECK(*s.hazWidth == Approx(2 * kMm));
    CHECK(*s.coolingTime == 8);
    CHECK_FALSE(s.height);
    CHECK_FALSE(s.rootMissing);
    Section cold = filletSection();
    cold.rootFusion = 0;
    (*cold.fusedFaces)[0].low = 1.2 * kMm; // unfused from the corner on
    CHECK(*stationOf(cold, WeldKind::fillet, 0).lackOfFusion == Approx(1.2 * kMm));
    (*cold.fusedFaces)[1] = {};
    CHECK(*stationOf(cold, WeldKind::fillet, 0).lackOfFusion == Approx(5 * kMm)); // length of the leg
    CHECK(*stationOf(cold, WeldKind::fillet, 0).overlap2 == Approx(5 * kMm));
}

TEST_CASE("a butt's station tells the root from both edges", "[stations]") {
    Section section;
    section.layers = 4;
    section.fusion.depth = 4 * kMm;
    section.fusedTop = {-4 * kMm, 4 * kMm};
    BeadShape& bead = section.bead.emplace();
    bead.height = 1 * kMm;
    bead.toes = {{{-3 * kMm, 0.6}, {3.4 * kMm, 0.6}}};
    bead.cover = {-3 * kMm, 3.4 * kMm};
    section.unfusedEdges = {0.8 * kMm, 2 * kMm};
    const WeldStation lacking = stationOf(section, WeldKind::butt, 0);
    CHECK(*lacking.rootMissing == Approx(0.8 * kMm));  // sum over both edges
    CHECK(*lacking.lackOfFusion == Approx(1.2 * kMm)); // one edge has more than the other
    CHECK(*lacking.overlap1 == Approx(-1 * kMm));
    CHECK(*lacking.overlap2 == Approx(-0.6 * kMm));
    CHECK(*lacking.middle == Approx(0.2 * kMm));
    section.unfusedEdges = {0, 0};
    section.root.height = 0.7 * kMm;
    const WeldStation through = stationOf(section, WeldKind::butt, 0);
    CHECK(*through.rootMissing == Approx(-0.7 * kMm));
    CHECK(*through.lackOfFusion == Approx(-0.7 * kMm));
    CHECK(*through.excessPenetration == Approx(0.7 * kMm));
    CHECK_FALSE(through.leg1);
}

TEST_CASE("means, extremes and straightness are those of the stations", "[stations]") {
    // The middles are on a tilted line, then alternately 0.3 mm to either side of it.
    const auto line = [](double off) {
        std::vector<WeldStation> stations;
        for (int i = 0; i < 20; ++i)
            stations.push_back(at(2 * i, 0.1 * i + (i / 2 % 2 == i % 2 ? off : -off)));
        return stations;
    };
    const WeldMeasures straight = summarise(line(0), WeldKind::bead, 2 * kMm, kMm);
    REQUIRE(straight.straightness);
    CHECK(*straight.straightness == Approx(0).margin(1e-9));
    CHECK(*straight.mean.toeWidth == Approx(19 * kMm));
    CHECK(*straight.least.toeWidth == 0);
    CHECK(*straight.greatest.toeWidth == Approx(38 * kMm));
    CHECK_FALSE(straight.mean.throat);
    CHECK(straight.length() == Approx(40 * kMm));
    CHECK(*summarise(line(0.3), WeldKind::bead, 2 * kMm, kMm).straightness == Approx(0.3 * kMm).epsilon(0.01));
    CHECK_FALSE(summarise({at(0, 0), at(2, 1)}, WeldKind::bead, 2 * kMm, kMm).straightness);
    CHECK(summarise({}, WeldKind::bead, 2 * kMm, kMm).stations.empty());
}

TEST_CASE("stations leave out the craters and stand a pitch apart", "[stations]") {
    const auto cuts = stationCuts(steel(), {-30 * kMm, 31 * kMm}, 0.4 * kMm, {});
    REQUIRE(cuts.size() == 25);
    CHECK(cuts.front().from == Approx(-24.5 * kMm)); // the rest of a pitch is split between both ends
    CHECK(cuts.back().to == Approx(25.5 * kMm));
    for (size_t i = 1; i < cuts.size(); ++i)
        CHECK(cuts[i].at() - cuts[i - 1].at() == Approx(2 * kMm));
    CHECK(stationCuts(steel(), {0, 8 * kMm}, kMm, {}).size() == 2); // a quarter at each end is left out
    CHECK(stationCuts(steel(), {0, 3 * kMm}, kMm, {}).empty());
    // With coarse particles each station is the mean of five layers, at unchanged places.
    const auto coarse = stationCuts(steel(), {-30 * kMm, 31 * kMm}, kMm, {});
    REQUIRE(coarse.size() == 25);
    CHECK(coarse[3].at() == Approx(cuts[3].at()));
    CHECK(coarse[3].to - coarse[3].from == Approx(5 * kMm));
}

TEST_CASE("the table has a row a station and empty cells where there is no figure", "[stations]") {
    WeldMeasures measures =
        summarise({stationOf(filletSection(), WeldKind::fillet, 3 * kMm)}, WeldKind::fillet, 2e-3, 1e-3);
    const std::string table = weldTable(measures);
    const auto lines = splitText(table, '\n');
    REQUIRE(lines.size() == 3); // the last line is empty
    const auto heads = splitText(lines[0], ','), cells = splitText(lines[1], ',');
    REQUIRE(heads.size() == stationFigures().size() + 1);
    REQUIRE(cells.size() == heads.size());
    CHECK(std::set<std::string_view>(heads.begin(), heads.end()).size() == heads.size());
    const auto cell = [&](std::string_view name) {
        for (size_t i = 0; i < heads.size(); ++i)
            if (heads[i] == name) return std::string(cells[i]);
        return std::string("no column");
    };
    CHECK(cell("place_mm") == "3");
    CHECK(cell("leg1_mm") == "6");
    CHECK(cell("undercut_2_mm") == "0.4");
    CHECK(cell("root_fused_percent") == "100");
    CHECK(cell("edge_angle_1_deg") == "51.5662");
    CHECK(cell("t85_s") == "8");
    CHECK(cell("height_mm").empty());
    const std::filesystem::path file = test::scratchFolder("stations") / "weld.csv";
    writeWeldTable(file, measures);
    CHECK(readTextFile(file) == table);
}

TEST_CASE("a bead of known shape is measured at all stations within half a spacing", "[stations]") {
    test::context();
    const PlateWeld weld(3);
    const WeldMeasures measures = weld.measure();
    REQUIRE(measures.stations.size() == 14); // 39.5 mm between the outermost cells' centres, less 5 at each end
    for (const WeldStation& station : measures.stations) {
        CHECK(*station.height / kMm == Approx(3).margin(0.25));
        CHECK(*station.toeWidth / kMm == Approx(6).margin(0.25));
        CHECK(*station.penetration / kMm == Approx(2).margin(0.25));
        CHECK(*station.undercut1 == Approx(0).margin(1e-6));
        CHECK(*station.excessPenetration == 0);
        CHECK(*station.hole == 0);
        CHECK(*station.facesFused == 1);
    }
    // The fed volume follows from the particles' share of the half circle's area.
    const double fed = static_cast<double>(weld.metal.size()) * std::pow(0.5 * kMm, 3) / (40 * kMm);
    CHECK(*measures.mean.deposited == Approx(fed).epsilon(0.03));
    REQUIRE(measures.straightness);
    CHECK(*measures.straightness / kMm < 0.05);
}

TEST_CASE("a bead that swings is not straight, and a seam that is not welded all along says so", "[stations]") {
    test::context();
    const WeldMeasures swinging = PlateWeld(2, 1.5F).measure();
    REQUIRE(swinging.straightness);
    CHECK(*swinging.straightness / kMm > 0.7);
    CHECK(*swinging.straightness / kMm < 1.3);
    StationSettings wholeSeam;
    wholeSeam.seam = {-28 * kMm, 28 * kMm};
    const WeldMeasures whole = PlateWeld(2).measure(wholeSeam);
    CHECK(whole.stations.size() == 23);
    CHECK(*whole.mean.facesFused == Approx(20.0 / 23).margin(0.05));
    CHECK(*whole.least.height == 0);
    CHECK(*whole.greatest.lackOfFusion == 0); // a place without weld
}

TEST_CASE("beyond the place where the torch stopped nothing is measured, and the weld is incomplete", "[stations]") {
    test::context();
    StationSettings settings;
    settings.seam = {-18 * kMm, 28 * kMm};
    settings.ends = 0;
    const PlateWeld weld(2); // from -20 to 20 mm
    const WeldMeasures whole = weld.measure(settings);
    CHECK(whole.stations.size() == 23);
    CHECK(*whole.mean.height / kMm < 1.8); // the bare plate beyond 20 mm counts
    CHECK(whole.isComplete());
    settings.passed = {-30 * kMm, 17 * kMm};
    const WeldMeasures welded = weld.measure(settings);
    CHECK(welded.stations.size() == 17); // 35 mm from the seam's start to the stop
    CHECK(welded.stations.front().place / kMm == Approx(-16.5));
    CHECK(*welded.least.facesFused == 1);
    CHECK(*welded.mean.height / kMm == Approx(2).margin(0.25));
    CHECK(welded.asked == Approx(46 * kMm));
    CHECK_FALSE(welded.isComplete());
    settings.seam = {-18 * kMm, 18 * kMm};
    CHECK(weld.measure(settings).isComplete()); // 1 mm less than asked for
    settings.passed = {30 * kMm, 40 * kMm};
    CHECK(weld.measure(settings).stations.empty());
    CHECK_FALSE(weld.measure(settings).craterDepth);
}

TEST_CASE("a crater is as deep as its lowest place under the lower of both its shores", "[stations]") {
    test::context();
    const double stop = 16.5;
    StationSettings settings;
    settings.stop = stop * kMm;
    settings.seam = {-18 * kMm, 18 * kMm};
    PlateWeld weld(3);
    const WeldMeasures filled = weld.measure(settings);
    REQUIRE(filled.craterDepth);
    CHECK(*filled.craterDepth / kMm < 0.25); // the weld only ends
    CHECK(*filled.craterSurface / kMm == Approx(3).margin(0.25));
    std::erase_if(weld.metal, [](const MetalSeed& seed) {
        return seed.position.x > 15e-3F && seed.position.x < 18e-3F && seed.position.y > 1e-3F;
    });
    const WeldMeasures hollow = weld.measure(settings);
    CHECK(*hollow.craterDepth / kMm == Approx(2).margin(0.5));
    CHECK(*hollow.craterSurface / kMm == Approx(1).margin(0.5));
    CHECK(hollow.stop == Approx(stop * kMm));
    settings.seam = {-18 * kMm, 10 * kMm}; // the weld ran on beyond it: its size at the end counts
    CHECK(*weld.measure(settings).craterSurface / kMm == Approx(3).margin(0.25));
}

TEST_CASE("a bead too low for toes has no width, and a place without weld the width 0", "[stations]") {
    Section section;
    section.layers = 4;
    section.bead.emplace().height = 0.3 * kMm;
    CHECK(*stationOf(section, WeldKind::butt, 0).toeWidth == 0);
    section.fusedTop = {-2 * kMm, 2 * kMm};
    CHECK_FALSE(stationOf(section, WeldKind::butt, 0).toeWidth);
}

TEST_CASE("fillets of tee and lap joints are measured at all stations within half a spacing", "[stations]") {
    test::context();
    for (const WorkpieceKind kind : {WorkpieceKind::Tee, WorkpieceKind::Lap}) {
        INFO(static_cast<int>(kind));
        // The upper plate of a lap joint is 4 mm thick.
        const glm::vec2 legs = kind == WorkpieceKind::Tee ? glm::vec2(6, 5) : glm::vec2(5, 3);
        const WeldMeasures weld = measureJoint(
            jointOf(kind), [&](glm::vec2 p) { return p.x > -0.2F && p.y > 0 && p.x / legs.x + p.y / legs.y < 1; },
            [&](glm::vec2 p) { return p.x > -1 && p.y > -1 && p.x < legs.x + 1 && p.y < legs.y + 1; });
        REQUIRE(weld.stations.size() == 14);
        CHECK(weld.kind == WeldKind::fillet);
        for (const WeldStation& s : weld.stations) {
            CHECK(*s.leg1 / kMm == Approx(static_cast<double>(legs.x)).margin(0.25));
            CHECK(*s.leg2 / kMm == Approx(static_cast<double>(legs.y)).margin(0.25));
            CHECK(*s.throat / kMm == Approx(static_cast<double>(legs.x * legs.y / glm::length(legs))).margin(0.25));
            CHECK(*s.convexity / kMm == Approx(0).margin(0.25));
            CHECK(*s.lackOfFusion / kMm == Approx(-1).margin(0.25));
            CHECK(*s.overlap1 / kMm == Approx(-1).margin(0.5));
            CHECK(*s.undercut1 == Approx(0).margin(1e-6));
            CHECK(*s.undercut2 == Approx(0).margin(1e-6));
            CHECK(*s.hole == 0);
            CHECK(*s.excessPenetration == 0);
        }
        CHECK(*weld.mean.rootFused == 1);
        CHECK(*weld.mean.facesFused == Approx(1));
    }
}

TEST_CASE("a butt weld is measured on both sides at all stations within half a spacing", "[stations]") {
    test::context();
    // The cap is 8 mm wide and 1.5 mm high, the root 4 mm wide and 1.5 mm high, and the edges are fused all through.
    const auto inCap = [](float across, float up, float half, float height) { // segment of a circle
        const float radius = 0.5F * (half * half + height * height) / height;
        return std::hypot(across, up + radius - height) < radius;
    };
    const auto metal = [&](glm::vec2 p) {
        if (p.y > 0) return inCap(p.x, p.y, 4, 1.5F);
        return p.y > -4 ? std::abs(p.x) < 2 : inCap(p.x, -4 - p.y, 2, 1.5F); // the gap is full
    };
    const WeldMeasures weld =
        measureJoint(jointOf(WorkpieceKind::Butt), metal, [](glm::vec2 p) { return std::abs(p.x) < 4.5F; });
    REQUIRE(weld.stations.size() == 14);
    CHECK(weld.kind == WeldKind::butt);
    for (const WeldStation& s : weld.stations) {
        CHECK(*s.toeWidth / kMm == Approx(8).margin(0.25));
        CHECK(*s.height / kMm == Approx(1.5).margin(0.25));
        CHECK(*s.excessPenetration / kMm == Approx(1.5).margin(0.25));
        CHECK(*s.rootWidth / kMm == Approx(4).margin(0.25));
        CHECK(*s.rootMissing / kMm == Approx(-1.5).margin(0.25));
        CHECK(*s.rootConcavity == Approx(0).margin(1e-6));
        CHECK(*s.underfill == Approx(0).margin(1e-6));
        CHECK(*s.overlap1 / kMm == Approx(-0.5).margin(0.5));
        CHECK(*s.hole == 0);
    }
    CHECK(*weld.mean.rootFused == 1);
    // Here the lower 2 mm of the gap have no metal, and the edges are fused down to there.
    const WeldMeasures shallow = measureJoint(
        jointOf(WorkpieceKind::Butt), [&](glm::vec2 p) { return p.y > -2 && metal(p); },
        [](glm::vec2 p) { return std::abs(p.x) < 4.5F && p.y > -2; });
    for (const WeldStation& s : shallow.stations) {
        CHECK(*s.rootMissing / kMm == Approx(2).margin(0.25));
        CHECK(*s.rootConcavity / kMm == Approx(2).margin(0.25));
        CHECK(*s.rootFused == 0);
    }
}

TEST_CASE("a weld in an outside corner is measured on the plates' edges within half a spacing", "[stations]") {
    test::context();
    WorkpieceParameters p = jointOf(WorkpieceKind::Corner);
    p.thicknessMm = 6;
    for (const glm::vec2 legs : {glm::vec2(4, 4), glm::vec2(5, 3.5F), glm::vec2(3.5F, 5)}) {
        INFO("legs of " << legs.x << " and " << legs.y << " mm");
        const WeldMeasures weld = measureJoint(
            p, [&](glm::vec2 at) { return at.x > -0.2F && at.y > 0 && at.x / legs.x + at.y / legs.y < 1; },
            [&](glm::vec2 at) { return at.x > -1 && at.y > -1 && at.x < legs.x + 0.5F && at.y < legs.y + 0.5F; });
        REQUIRE(weld.stations.size() == 14);
        CHECK(weld.kind == WeldKind::fillet);
        for (const WeldStation& s : weld.stations) {
            CHECK(*s.leg1 / kMm == Approx(static_cast<double>(legs.x)).margin(0.25));
            CHECK(*s.leg2 / kMm == Approx(static_cast<double>(legs.y)).margin(0.25));
            CHECK(*s.throat / kMm == Approx(static_cast<double>(legs.x * legs.y / glm::length(legs))).margin(0.25));
            CHECK(*s.penetration / kMm == Approx(1).margin(0.25));
            CHECK(*s.lackOfFusion / kMm == Approx(0).margin(0.25));
            CHECK_FALSE(s.rootFusion);        // air is behind the root
            CHECK_FALSE(s.excessPenetration); // a lower face is missing too
        }
        CHECK(*weld.mean.rootFused == Approx(1));
        CHECK(*weld.mean.facesFused == Approx(1));
    }
    // The faces are fused only 1 mm from the corner on, so the root is not.
    const auto metal = [](glm::vec2 at) { return at.x > -0.2F && at.y > 0 && at.x + at.y < 4; };
    const WeldMeasures cold = measureJoint(p, metal, [](glm::vec2 at) {
        return std::max(at.x, at.y) > 1 && std::min(at.x, at.y) > -1 && std::max(at.x, at.y) < 4;
    });
    for (const WeldStation& s : cold.stations)
        CHECK(*s.lackOfFusion / kMm == Approx(1).margin(0.25));
    CHECK(*cold.mean.rootFused == 0);
    CHECK(*cold.mean.facesFused == Approx(1));
}

TEST_CASE("undercut is not told where a weld covers a corner's face up to its edge", "[stations]") {
    test::context();
    const auto weld = measureJoint(
        jointOf(WorkpieceKind::Corner), [](glm::vec2 at) { return at.x > -0.2F && at.y > 0 && at.x + at.y < 4; },
        [](glm::vec2 at) { return at.x > -1 && at.y > -1; });
    REQUIRE_FALSE(weld.stations.empty());
    for (const WeldStation& s : weld.stations) {
        CHECK_FALSE(s.undercut1);
        CHECK_FALSE(s.undercut2);
        CHECK(*s.throat / kMm == Approx(4 / std::numbers::sqrt2).margin(0.25));
    }
}

TEST_CASE("a weld in a bevelled groove is measured over the plates and down to its root", "[stations]") {
    test::context();
    WorkpieceParameters p = jointOf(WorkpieceKind::Butt);
    p.thicknessMm = 6;
    p.gapMm = 1;
    p.rootFaceMm = 1;
    p.bevelDeg = 30;
    // A bevel of 5 mm makes the groove 6.77 mm wide at the top; the cap is 8 by 1.5 mm, the root 3 by 1 mm.
    const auto inCap = [](float across, float up, float half, float height) { // segment of a circle
        const float radius = 0.5F * (half * half + height * height) / height;
        return std::hypot(across, up + radius - height) < radius;
    };
    const auto metal = [&](glm::vec2 at) {
        if (at.y > 0) return inCap(at.x, at.y, 4, 1.5F);
        return at.y > -6 ? std::abs(at.x) < 5 : inCap(at.x, -6 - at.y, 1.5F, 1); // the groove is full
    };
    const auto halfGroove = [](float y) { return 0.5F + std::max(y + 5, 0.0F) * 0.57735F; };
    const auto nearGroove = [&](glm::vec2 at) { return std::abs(at.x) < halfGroove(at.y) + 1.25F; };
    const WeldMeasures weld = measureJoint(p, metal, nearGroove);
    REQUIRE(weld.stations.size() == 14);
    for (const WeldStation& s : weld.stations) {
        CHECK(*s.toeWidth / kMm == Approx(8).margin(0.25));
        CHECK(*s.height / kMm == Approx(1.5).margin(0.25));
        CHECK(*s.excessPenetration / kMm == Approx(1).margin(0.25));
        CHECK(*s.fusedWidth / kMm == Approx(8.5).margin(0.25)); // from hot cell to hot cell of the upper face
        CHECK(*s.rootMissing / kMm == Approx(-1).margin(0.25));
        CHECK(*s.underfill == Approx(0).margin(1e-6));
        CHECK(*s.hole == 0);
    }
    CHECK(*weld.mean.rootFused == 1);
    CHECK(*weld.mean.facesFused == 1);
    // The bevels are fused from 3 mm over the lower face on.
    const WeldMeasures shallow = measureJoint(p, metal, [&](glm::vec2 at) { return at.y > -3 && nearGroove(at); });
    for (const WeldStation& s : shallow.stations)
        CHECK(*s.rootMissing / kMm == Approx(3).margin(0.25));
    CHECK(*shallow.mean.rootFused == 0);
}

TEST_CASE("a tack counts as deposited metal, not as part of the joint", "[stations]") {
    test::context();
    const auto metal = [](glm::vec2 at) { return at.x > -0.2F && at.y > 0 && at.x + at.y < 5; };
    const auto fused = [](glm::vec2 at) { return at.x > -1 && at.y > -1 && at.x < 6 && at.y < 6; };
    WorkpieceParameters p = jointOf(WorkpieceKind::Tee);
    const WeldMeasures bare = measureJoint(p, metal, fused);
    p.tackCount = 1; // a tack in the middle
    const WeldMeasures tacked = measureJoint(p, metal, fused);
    REQUIRE(tacked.stations.size() == bare.stations.size());
    for (size_t i = 0; i < bare.stations.size(); ++i) {
        const WeldStation &a = bare.stations[i], &b = tacked.stations[i];
        CHECK(*b.leg1 == Approx(*a.leg1).margin(1e-4));
        CHECK(*b.throat == Approx(*a.throat).margin(1e-4));
        CHECK(*b.penetration == Approx(*a.penetration));
        CHECK(*b.deposited == Approx(*a.deposited).epsilon(0.01));
    }
}

namespace {

/// Measures a pipe of 50 mm with a wall of 5 mm and particles of 1 mm, welded from 10 to 60 mm of its seam with metal
/// of this section: z and height over the outer face, mm.
WeldMeasures measurePipe(const WorkpieceParameters& p, const Inside& metal, const Inside& fused) {
    Workpiece piece = makeWorkpiece(p);
    constexpr float kRadius = 25;
    const auto place = [](const glm::vec3& at) { // position along the seam, z, height
        const glm::vec3 mm = at * 1e3F;
        const float angle = std::atan2(mm.x, mm.y + kRadius);
        return glm::vec3(angle * kRadius, mm.z, std::hypot(mm.x, mm.y + kRadius) - kRadius);
    };
    const auto welded = [](const glm::vec3& at) { return at.x > 10 && at.x < 60; };
    std::set<size_t> taken;
    for (MetalSeed& seed : piece.seeds) {
        const glm::vec3 at = place(seed.position);
        if (welded(at) && fused({at.y, at.z})) seed.temperature = 1900;
        taken.insert(piece.lattice.index(piece.lattice.cellAt(seed.position)));
    }
    std::vector<MetalSeed> weld;
    for (const MetalSeed& seed : latticeSeeds(piece.lattice, piece.low, piece.high, 2000)) {
        const glm::vec3 at = place(seed.position);
        if (!taken.contains(piece.lattice.index(piece.lattice.cellAt(seed.position))) && welded(at) &&
            metal({at.y, at.z}))
            weld.push_back({seed.position, 2000, PHASE_ALIVE, glm::vec3(0)});
    }
    MetalState state(piece.lattice, HeatTable(steel()), 7850, piece.seeds.size() + weld.size());
    state.add(piece.seeds);
    state.add(weld);
    return measureWeld(WeldParticles(state, piece.parts(), 25 * kMm), steel(), weldKindOf(p));
}

WorkpieceParameters smallPipe(float gap) {
    WorkpieceParameters p;
    p.kind = static_cast<int>(WorkpieceKind::Pipe);
    p.diameterMm = 50;
    p.thicknessMm = 5;
    p.widthMm = 40;
    p.gapMm = gap;
    p.roomAboveMm = 8;
    return p;
}

} // namespace

TEST_CASE("a bead around a pipe is measured within half a spacing, one station's width within two thirds",
          "[stations]") {
    test::context();
    const WeldMeasures weld = measurePipe(
        smallPipe(0), [](glm::vec2 at) { return at.y > 0 && glm::length(at) < 4; },
        [](glm::vec2 at) { return std::abs(at.x) < 4.4F && at.y > -2; });
    CHECK(weld.kind == WeldKind::bead);
    REQUIRE(weld.stations.size() == 19); // 49 to 50 mm, less 5 at each end
    for (const WeldStation& s : weld.stations) {
        INFO(s.place / kMm << " mm along the seam");
        CHECK(s.place > 14 * kMm);
        CHECK(s.place < 56 * kMm);
        CHECK(*s.height / kMm == Approx(4).margin(0.5));
        CHECK(*s.toeWidth / kMm ==
              Approx(8).margin(0.65)); // one station is 0.61 mm off, the mean within half a spacing
        CHECK(*s.penetration / kMm == Approx(2).margin(0.5));
        CHECK(*s.excessPenetration / kMm == Approx(0).margin(0.5));
        CHECK(*s.hole == 0);
    }
    CHECK(*weld.mean.toeWidth / kMm == Approx(8).margin(0.5));
    // A half circle's area is 1.7 mm over the face on average, where the circumference is longer.
    const double exact = std::numbers::pi * 8 * (1 + 16 / (3 * std::numbers::pi) / 25);
    CHECK(*weld.mean.deposited / 1e-6 == Approx(exact).epsilon(0.03));
    CHECK(*weld.mean.facesFused == Approx(1));
}

TEST_CASE("a butt weld around a pipe is measured down to its root within half a spacing", "[stations]") {
    test::context();
    const auto metal = [](glm::vec2 at) {
        if (at.y > 0) return std::hypot(at.x, at.y + 3) < 5; // 8 mm wide, 2 mm high
        return at.y > -5 && std::abs(at.x) < 1;              // the gap, flush with the inside
    };
    const auto near = [](glm::vec2 at) { return std::abs(at.x) < 4.5F; };
    const WeldMeasures sound = measurePipe(smallPipe(2), metal, near);
    CHECK(sound.kind == WeldKind::butt);
    REQUIRE(sound.stations.size() == 19);
    for (const WeldStation& s : sound.stations) {
        INFO(s.place / kMm << " mm along the seam");
        CHECK(*s.height / kMm == Approx(2).margin(0.5));
        CHECK(*s.rootMissing / kMm == Approx(0).margin(0.5));
        CHECK(*s.underfill / kMm == Approx(0).margin(0.5));
        CHECK(*s.hole == 0);
    }
    CHECK(*sound.mean.rootFused == Approx(1));
    const WeldMeasures shallow = measurePipe(smallPipe(2), metal, [&](glm::vec2 at) { return near(at) && at.y > -3; });
    CHECK(*shallow.mean.rootMissing / kMm == Approx(2).margin(0.5));
    CHECK(*shallow.mean.rootFused < 0.1);
}
