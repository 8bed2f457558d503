// Welding positions: they turn workpiece and gravity according to the standards, and molten metal runs down in each.
#include "core/weld/workpiece/position.hpp"

#include "core/weld/process/weld.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using namespace meltpool;

namespace {

constexpr float kMm = 1e-3F;
constexpr float kHot = 2100; ///< temperature of the metal, K

const glm::vec3 kAlong(1, 0, 0), kOut(0, 1, 0), kUp(0, 1, 0), kDown(0, -1, 0), kToWelder(0, 0, 1);
const glm::vec3 kBisector = glm::normalize(glm::vec3(0, 1, 1));

WorkpieceParameters pieceOf(WorkpieceKind kind, WeldPosition position) {
    WorkpieceParameters p;
    p.kind = static_cast<int>(kind);
    p.position = static_cast<int>(position);
    return p;
}

/// Returns a direction of the workpiece in the room.
glm::vec3 inRoom(WorkpieceKind kind, WeldPosition position, const glm::vec3& direction) {
    return fixtureOf(pieceOf(kind, position)).turn * direction;
}

void checkPoints(WorkpieceKind kind, WeldPosition position, const glm::vec3& direction, const glm::vec3& expected) {
    const glm::vec3 found = inRoom(kind, position, direction);
    INFO(positionNames()[static_cast<size_t>(position)] << ": " << found.x << " " << found.y << " " << found.z);
    CHECK(glm::distance(found, expected) < 1e-6F);
}

/// A plate of hot but solid steel, 24 x 24 mm.
struct HotPlate {
    explicit HotPlate(WeldPosition position) {
        WorkpieceParameters p = pieceOf(WorkpieceKind::Plate, position);
        p.lengthMm = p.widthMm = 24;
        p.thicknessMm = 4;
        p.temperatureC = 1400;
        p.roomAboveMm = 12;
        piece = makeWorkpiece(p);
        ProcessSettings settings;
        settings.choose<Flame>();
        WeldSurroundings around;
        around.lossless = true;
        weld = std::make_unique<Weld>(test::shaders(), shippedMaterial("s235"), piece, settings, around);
    }

    /// Adds molten metal at rest in a box over the plate, mm.
    void pour(const glm::ivec3& low, const glm::ivec3& high) {
        std::vector<MetalSeed> melt;
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x)
                    melt.push_back({(glm::vec3(x, y, z) + 0.5F) * kMm, kHot, PHASE_ALIVE | PHASE_LIQUID, glm::vec3(0)});
        weld->metal().step({}, melt, nullptr);
        poured = melt.size();
    }

    void run(double seconds) {
        for (double time = 0; time < seconds; time += weld->timeStep())
            weld->metal().step({}, {}, nullptr);
    }

    /// Returns the middle of the poured metal, mm.
    glm::vec3 middle() const {
        glm::vec3 sum(0);
        for (const glm::vec3& place : places())
            sum += place;
        return sum / static_cast<float>(poured);
    }

    std::vector<glm::vec3> places() const {
        const auto all = weld->metal().state().position.read<vec4>(piece.seeds.size() + poured);
        std::vector<glm::vec3> found;
        for (size_t i = piece.seeds.size(); i < all.size(); ++i)
            found.push_back(glm::vec3(all[i]) * 1e3F);
        return found;
    }

    Workpiece piece;
    std::unique_ptr<Weld> weld;
    size_t poured = 0;
};

} // namespace

TEST_CASE("each position holds the joint as the standards say", "[position]") {
    using Kind = WorkpieceKind;
    using Position = WeldPosition;
    for (const Kind kind : {Kind::Plate, Kind::Butt}) {
        checkPoints(kind, Position::g1, kOut, kUp);
        checkPoints(kind, Position::flat, kOut, kUp);
        checkPoints(kind, Position::g2, kOut, kToWelder);   // the plate is vertical
        checkPoints(kind, Position::g2, kAlong, {1, 0, 0}); // and the seam horizontal
        checkPoints(kind, Position::g3, kOut, kToWelder);
        checkPoints(kind, Position::g3, kAlong, kUp);
        checkPoints(kind, Position::g4, kOut, kDown);
    }
    for (const Kind kind : {Kind::Tee, Kind::Lap, Kind::Corner}) {
        checkPoints(kind, Position::f1, kBisector, kUp); // trough position
        checkPoints(kind, Position::flat, kBisector, kUp);
        checkPoints(kind, Position::f1, kAlong, {1, 0, 0});
        checkPoints(kind, Position::f2, kOut, kUp);
        checkPoints(kind, Position::f3, kAlong, kUp);
        checkPoints(kind, Position::f3, kBisector, kToWelder);
        checkPoints(kind, Position::f4, kOut, kDown);
        checkPoints(kind, Position::f4, {0, 0, 1}, kToWelder); // the upright plate remains behind
    }
    for (size_t i = 0; i < positionNames().size(); ++i) {
        const glm::mat3 turn = fixtureOf(pieceOf(Kind::Butt, static_cast<Position>(i))).turn;
        CHECK(glm::determinant(turn) == Approx(1));
        const glm::mat3 product = glm::transpose(turn) * turn;
        for (int axis = 0; axis < 3; ++axis)
            CHECK(glm::distance(product[axis], glm::mat3(1)[axis]) < 1e-6F);
    }
}

TEST_CASE("a workpiece as it lies has gravity and table where they were without positions", "[position]") {
    const Workpiece piece = makeWorkpiece(pieceOf(WorkpieceKind::Tee, WeldPosition::asItLies));
    CHECK(piece.turn == glm::mat3(1));
    CHECK(piece.up == glm::vec3(0, 1, 0));
    CHECK(piece.floorHeight == piece.low.y);
    CHECK(piece.floorHeight == Approx(-0.012F));
}

TEST_CASE("the table lies under the workpiece in every position, with room to fall", "[position]") {
    for (size_t i = 0; i < positionNames().size(); ++i) {
        const auto position = static_cast<WeldPosition>(i);
        for (const WorkpieceKind kind : {WorkpieceKind::Plate, WorkpieceKind::Tee, WorkpieceKind::Corner}) {
            if (!positionFits(kind, position)) continue;
            const Workpiece piece = makeWorkpiece(pieceOf(kind, position));
            INFO(positionNames()[i] << " of " << static_cast<int>(kind));
            float lowest = 1, lowestMetal = 1;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 place(corner & 1 ? piece.low.x : piece.high.x, corner & 2 ? piece.low.y : piece.high.y,
                                      corner & 4 ? piece.low.z : piece.high.z);
                lowest = std::min(lowest, (piece.turn * place).y);
            }
            for (const MetalSeed& seed : piece.seeds)
                lowestMetal = std::min(lowestMetal, (piece.turn * seed.position).y);
            CHECK(piece.floorHeight == Approx(lowest));
            CHECK(lowestMetal - piece.floorHeight > 5.9e-3F);
        }
    }
}

TEST_CASE("a pool on an upright plate runs down, along the seam or across it", "[position]") {
    test::context();
    for (const WeldPosition position : {WeldPosition::g1, WeldPosition::g2, WeldPosition::g3}) {
        INFO(positionNames()[static_cast<size_t>(position)]);
        HotPlate plate(position);
        plate.pour({-3, 0, -3}, {3, 4, 3});
        const glm::vec3 before = plate.middle();
        plate.run(0.4);
        const glm::vec3 way = plate.piece.turn * (plate.middle() - before);
        INFO("went " << way.x << " " << way.y << " " << way.z << " mm in the room");
        CHECK(plate.weld->metal().statistics().nonFinite == 0);
        CHECK(std::abs(way.x) < 0.7F); // no sideways motion
        if (position == WeldPosition::g1)
            CHECK(std::abs(way.z) < 0.7F);
        else
            CHECK(way.y < -2);
    }
}

TEST_CASE("overhead a film hangs on the plate, and a free drop falls on the table below", "[position]") {
    test::context();
    HotPlate film(WeldPosition::g4);
    film.pour({-3, 0, -3}, {3, 1, 3});
    film.run(0.3);
    for (const glm::vec3& place : film.places())
        CHECK(place.y < 3);
    HotPlate drop(WeldPosition::g4);
    drop.pour({-1, 7, -1}, {1, 9, 1});
    drop.run(0.3);
    const float floor = -drop.piece.floorHeight / kMm; // the table's y in the workpiece's frame, mm
    CHECK(floor > 17);
    for (const glm::vec3& place : drop.places()) {
        CHECK(place.y > floor - 3);
        CHECK(place.y < floor);
    }
}

TEST_CASE("a cut-off piece falls on the table of its position", "[position]") {
    test::context();
    for (const WeldPosition position : {WeldPosition::g1, WeldPosition::g2, WeldPosition::g3, WeldPosition::g4}) {
        WorkpieceParameters p = pieceOf(WorkpieceKind::Plate, position);
        p.lengthMm = p.widthMm = 16;
        p.thicknessMm = 4;
        Workpiece piece = makeWorkpiece(p);
        // A loose cube of solid metal is over the plate's face.
        const glm::vec3 place = glm::vec3(0, 6, 0) * kMm;
        const size_t first = piece.seeds.size();
        for (const MetalSeed& seed : latticeSeeds(piece.lattice, place - 1.5F * kMm, place + 1.5F * kMm, 300))
            piece.seeds.push_back(seed);
        REQUIRE(piece.seeds.size() > first);
        ProcessSettings settings;
        settings.choose<Flame>();
        Weld weld(test::shaders(), shippedMaterial("s235"), piece, settings);
        for (double time = 0; time < 0.5; time += weld.timeStep())
            weld.metal().step({}, {}, nullptr);
        const auto all = weld.metal().state().position.read<vec4>(piece.seeds.size());
        float lowest = 1;
        for (size_t i = first; i < all.size(); ++i)
            lowest = std::min(lowest, glm::dot(glm::vec3(all[i]), piece.up) - piece.floorHeight);
        INFO(positionNames()[static_cast<size_t>(position)] << ": " << lowest * 1e3F << " mm over the table");
        const bool lands = position != WeldPosition::g1; // in these positions the cube falls onto the plate
        CHECK((lowest < 1.2F * kMm) == lands);
        CHECK(lowest > -0.3F * kMm);
    }
}
