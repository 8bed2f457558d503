// The rolled faces of each workpiece, and the direction of its seam.
#include "core/weld/workpiece/rolled_faces.hpp"
#include "tests/support/catch.hpp"

#include <glm/vector_relational.hpp>

#include <algorithm>

using namespace meltpool;

namespace {

RolledFaces of(WorkpieceKind kind, float bevel = 0) {
    WorkpieceParameters parameters;
    parameters.kind = static_cast<int>(kind);
    parameters.bevelDeg = bevel;
    parameters.spacingMm = 2;
    parameters.thicknessMm = 8;
    return rolledFaces(parameters, makeWorkpiece(parameters));
}

} // namespace

TEST_CASE("plates are rolled across their thickness and ground beside a seam along x") {
    for (const WorkpieceKind kind : {WorkpieceKind::Plate, WorkpieceKind::Lap, WorkpieceKind::Butt}) {
        const RolledFaces rolled = of(kind);
        REQUIRE(rolled.count == (kind == WorkpieceKind::Plate ? 1 : 2));
        for (size_t i = 0; i < rolled.count; ++i)
            CHECK(rolled.parts[i].faces == glm::vec3(0, 1, 0));
        CHECK(rolled.across == glm::vec3(0, 1, 1));
        CHECK(rolled.ground == Approx(0.01));
    }
    const RolledFaces bevelled = of(WorkpieceKind::Butt, 30); // bevels are outside its parts
    REQUIRE(bevelled.count == 2);
    CHECK(std::max(bevelled.parts[0].low.z, bevelled.parts[1].low.z) > 4e-3F);
}

TEST_CASE("the plates of a tee and of a corner are rolled across each its own thickness") {
    for (const WorkpieceKind kind : {WorkpieceKind::Tee, WorkpieceKind::Corner}) {
        const RolledFaces rolled = of(kind);
        REQUIRE(rolled.count == 2);
        CHECK(rolled.parts[0].faces + rolled.parts[1].faces == glm::vec3(0, 1, 1));
    }
}

TEST_CASE("a pipe is rolled around its axis, along which the seam is ground; cast pieces are not rolled") {
    const RolledFaces pipe = of(WorkpieceKind::Pipe);
    REQUIRE(pipe.count == 1);
    CHECK(pipe.parts[0].faces == glm::vec3(1, 1, 0));
    CHECK(pipe.across == glm::vec3(0, 0, 1));
    CHECK(glm::all(glm::lessThan(pipe.parts[0].low, pipe.parts[0].high)));
    CHECK(of(WorkpieceKind::Cube).count == 0);
    CHECK(of(WorkpieceKind::Bridge).count == 0);
}
