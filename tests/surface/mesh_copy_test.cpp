// The mesh in main memory: closed after every kind of update, and reduced to the bodies.
#include "core/base/error.hpp"
#include "core/surface/mesh_bodies.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/surface/surface_twin.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>

namespace meltpool {

using glm::ivec3;
using glm::vec3;
using glm::vec4;

namespace {

using Particles = std::vector<vec4>;

void updateWith(Surface& surface, const Particles& particles) {
    const gl::Buffer buffer("particles", std::span<const vec4>(particles));
    surface.update({&buffer, particles.size()}, nullptr);
    glFinish();
}

test::Mesh meshOf(const MeshCopy& copy) {
    return {copy.vertices, copy.indices};
}

bool isIn(ivec3 corner, int low, int high) {
    return glm::all(glm::greaterThanEqual(corner, ivec3(low))) && glm::all(glm::lessThanEqual(corner, ivec3(high)));
}

/// Returns a particle exactly on each corner of a grid of 20 cells in -1..1 that `take` accepts, corners numbered from
/// 0 along each axis: with influence 1 exactly these corners are inside.
template <class Take>
Particles onCorners(Take take) {
    Particles particles;
    for (int z = 0; z <= 20; ++z)
        for (int y = 0; y <= 20; ++y)
            for (int x = 0; x <= 20; ++x)
                if (take(ivec3(x, y, z))) particles.emplace_back(vec3(x, y, z) * 0.1f - 1.0f, 0.5f);
    return particles;
}

const SurfaceParameters kOnCorners{20, 1, 0.5f};

} // namespace

TEST_CASE("the copied mesh is the surface's, after a rebuild and after changes") {
    Surface surface(test::shaders(), {96, 3, 0.6f, true, int(SurfaceKernel::smooth)}, vec3(-1), vec3(1));
    surface.incremental.enabled = true;
    Particles particles; // a block of 24 an edge: one particle changes less than a third of its mesh
    for (int i = 0; i < 24 * 24 * 24; ++i)
        particles.emplace_back((vec3(i % 24, i / 24 % 24, i / 576) - 11.5f) * 0.04f, 0.5f);
    updateWith(surface, particles);
    const MeshCopy first = copyMesh(surface);
    CHECK(first.indices == test::readMesh(surface).indices);
    CHECK(first.peaks.empty());
    CHECK(test::unmatchedSides(meshOf(first)).empty());
    particles[12 + 23 * 24 + 12 * 576].y += 0.06f; // leaves the upper face
    updateWith(surface, particles);
    REQUIRE_FALSE(surface.statistics().rebuilt);
    const MeshCopy second = copyMesh(surface);
    CHECK(test::unmatchedSides(meshOf(second)).empty());
    CHECK(test::meshVolume(meshOf(second)) != test::meshVolume(meshOf(first)));
    const MeshCopy bodies = outerBodies(second);
    CHECK(bodies.vertices.size() < second.vertices.size()); // vertices of removed triangles are left out
    CHECK(test::unmatchedSides(meshOf(bodies)).empty());
}

TEST_CASE("a ball is one body with its volume and outward normals") {
    Surface surface(test::shaders(), {32, 8, 0.6f}, vec3(-1), vec3(1));
    const vec3 centre(0.013f, -0.021f, 0.008f);
    updateWith(surface, {vec4(centre, 0.0f)});
    const MeshCopy ball = outerBodies(copyMesh(surface));
    const double radius = 0.4 * (std::sqrt(3.0) / 2 + 7 * std::sqrt(3.0)) * 2 / 32;
    CHECK(countParts(ball) == 1);
    CHECK(test::unmatchedSides(meshOf(ball)).empty());
    CHECK(test::meshVolume(meshOf(ball)) == Approx(4 * 3.14159265 / 3 * radius * radius * radius).epsilon(0.025));
    size_t inward = 0;
    for (const SurfaceVertex& v : ball.vertices)
        inward += glm::dot(v.normal, v.position - centre) <= 0;
    CHECK(inward == 0);
}

TEST_CASE("hollows and what lies in them are left out; bodies beside each other stay") {
    Surface surface(test::shaders(), kOnCorners, vec3(-1), vec3(1));
    // The set is a box with a hollow that contains a drop, and two small boxes outside.
    const auto box = [](ivec3 c) { return isIn(c, 2, 12); };
    const auto hollow = [](ivec3 c) { return isIn(c, 5, 9); };
    const auto drop = [](ivec3 c) { return isIn(c, 7, 7); };
    const auto others = [](ivec3 c) { return isIn(c, 14, 16) || (isIn(c - ivec3(0, 0, 15), 2, 4)); };
    updateWith(surface, onCorners([&](ivec3 c) { return (box(c) && !hollow(c)) || drop(c) || others(c); }));
    const MeshCopy all = copyMesh(surface);
    CHECK(countParts(all) == 5);
    const MeshCopy bodies = outerBodies(all);
    CHECK(countParts(bodies) == 3);
    CHECK(test::unmatchedSides(meshOf(bodies)).empty());

    updateWith(surface, onCorners([&](ivec3 c) { return box(c) || others(c); })); // set without the hollow
    const MeshCopy whole = outerBodies(copyMesh(surface));
    CHECK(test::meshVolume(meshOf(bodies)) == Approx(test::meshVolume(meshOf(whole))).epsilon(1e-6));
    CHECK(bodies.vertices.size() == whole.vertices.size());
    CHECK(bodies.vertices.front().position.x < 0); // largest body first
}

TEST_CASE("a ring does not hold the drop in its hole, and a cup not the one above its floor") {
    Surface surface(test::shaders(), kOnCorners, vec3(-1), vec3(1));
    const auto hole = [](ivec3 c) { return c.x >= 6 && c.x <= 14 && c.z >= 6 && c.z <= 14; };
    const auto drop = [](ivec3 c) { return isIn(c, 9, 11); };
    updateWith(surface,
               onCorners([&](ivec3 c) { return (isIn(c, 3, 17) && c.y >= 7 && c.y <= 13 && !hole(c)) || drop(c); }));
    CHECK(countParts(outerBodies(copyMesh(surface))) == 2);
    updateWith(surface, onCorners([&](ivec3 c) { return (isIn(c, 3, 17) && !(hole(c) && c.y > 5)) || drop(c); }));
    CHECK(countParts(outerBodies(copyMesh(surface))) == 2);
}

TEST_CASE("metal at the box is closed by caps, and nothing gives nothing") {
    Surface surface(test::shaders(), kOnCorners, vec3(-1), vec3(1));
    updateWith(surface, onCorners([](ivec3) { return true; }));
    const MeshCopy full = outerBodies(copyMesh(surface));
    CHECK(test::unmatchedSides(meshOf(full)).empty());
    CHECK(test::meshVolume(meshOf(full)) == Approx(8.0));
    updateWith(surface, {});
    const MeshCopy nothing = outerBodies(copyMesh(surface));
    CHECK(nothing.indices.empty());
    CHECK(nothing.vertices.empty());
}

TEST_CASE("a mesh that was cut because it did not fit is not copied") {
    Surface surface(test::shaders(), {48, 1, 0.5f}, vec3(-1), vec3(1));
    Particles particles; // every second corner, as on a chessboard: the largest possible surface
    for (int i = 0; i < 49 * 49 * 49; ++i) {
        const ivec3 c(i % 49, i / 49 % 49, i / 49 / 49);
        if ((c.x + c.y + c.z) % 2 == 0) particles.emplace_back(vec3(c) / 24.0f - 1.0f, 0.5f);
    }
    updateWith(surface, particles);
    REQUIRE(surface.statistics().overflow);
    CHECK_THROWS_AS(copyMesh(surface), RuntimeFault);
}

} // namespace meltpool
