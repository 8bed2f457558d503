// The bodies of a lesson's metal as a mesh: the original plate, independent of the pictures' grid.
#include "core/surface/mesh_bodies.hpp"
#include "core/training/trainer/body_mesh.hpp"
#include "core/training/trainer/trainer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>

using namespace meltpool;

namespace {

Lesson smallPlate(float spacingMm) {
    Lesson lesson = findLesson("gmaw-bead", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 24;
    lesson.workpiece.widthMm = 20;
    lesson.workpiece.thicknessMm = 4;
    lesson.workpiece.spacingMm = spacingMm;
    return lesson;
}

MeshCopy bodiesOf(const Trainer& trainer) {
    return bodyMesh(test::shaders(), trainer.metal(), trainer.lesson().surface);
}

struct Measures {
    double above = 0;                ///< area seen from above over all layers, mm²
    double volume = 0;               ///< mm³
    size_t inward = 0;               ///< triangles with a vertex normal that points inwards
    glm::dvec3 low{1e9}, high{-1e9}; ///< mm
};

Measures measure(const MeshCopy& mesh) {
    Measures m;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        glm::dvec3 p[3], n[3];
        for (size_t j = 0; j < 3; ++j) {
            p[j] = glm::dvec3(mesh.vertices[mesh.indices[i + j]].position) * 1e3;
            n[j] = mesh.vertices[mesh.indices[i + j]].normal;
            m.low = glm::min(m.low, p[j]);
            m.high = glm::max(m.high, p[j]);
        }
        const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]) / 2.0;
        m.above += std::max(area.y, 0.0);
        m.volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6;
        m.inward += std::any_of(n, n + 3, [&](const glm::dvec3& each) { return glm::dot(each, area) < 0; });
    }
    return m;
}

/// True if every side belongs to two triangles that use it in opposite directions.
bool isClosed(const MeshCopy& mesh) {
    std::map<std::pair<unsigned, unsigned>, int> sides;
    for (size_t i = 0; i < mesh.indices.size(); ++i)
        ++sides[{mesh.indices[i], mesh.indices[i % 3 == 2 ? i - 2 : i + 1]}];
    return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
        const auto back = sides.find({side.first.second, side.first.first});
        return side.second == 1 && back != sides.end() && back->second == 1;
    });
}

} // namespace

TEST_CASE("a plate's mesh is the plate, in a grid of pictures that makes a sponge of it too", "[training]") {
    for (const float spacing : {1.0F, 0.5F}) {
        INFO("spacing " << spacing);
        Lesson lesson = smallPlate(spacing);
        lesson.surface.caps = false; // a file's mesh is closed even without caps
        const Trainer trainer(test::shaders(), lesson);
        const MeshCopy mesh = bodiesOf(trainer);
        const Measures m = measure(mesh);
        CHECK(m.above == Approx(480).epsilon(0.03));
        CHECK(m.volume == Approx(1920).epsilon(0.05));
        CHECK(m.inward < mesh.indices.size() / 3 / 100); // a normal may lean over an edge next to it
        CHECK(isClosed(mesh));
        CHECK(m.low.x == Approx(-12).margin(0.25));
        CHECK(m.high.x == Approx(12).margin(0.25));
        CHECK(m.low.y == Approx(-4).margin(0.25));
        CHECK(m.high.y == Approx(0).margin(0.25));
        CHECK(m.low.z == Approx(-10).margin(0.25));
        CHECK(m.high.z == Approx(10).margin(0.25));
        REQUIRE(mesh.peaks.size() == mesh.vertices.size());
        for (const SurfaceVertex& vertex : mesh.vertices)
            REQUIRE(vertex.temperature == Approx(293.15).margin(10));
    }
}

TEST_CASE("plates with an open gap are two bodies, and tacks make them one", "[training]") {
    Lesson lesson = findLesson("gtaw-butt", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.workpiece.lengthMm = 30;
    lesson.workpiece.gapMm = 3;
    const Trainer tacked(test::shaders(), lesson);
    CHECK(countParts(bodiesOf(tacked)) == 1);
    lesson.workpiece.tackCount = 0;
    const Trainer untacked(test::shaders(), lesson);
    const MeshCopy mesh = bodiesOf(untacked);
    CHECK(countParts(mesh) == 2);
    CHECK(isClosed(mesh));
    CHECK(measure(mesh).volume == Approx(30.0 * (41 - 3) * 3).epsilon(0.06));
}

TEST_CASE("y of the mesh points up where the plate hangs overhead", "[training]") {
    Lesson plate = smallPlate(1);
    plate.set("position", "4G", "test");
    const Trainer hanging(test::shaders(), plate);
    const Measures m = measure(bodiesOf(hanging));
    CHECK(m.above == Approx(480).epsilon(0.03));
    CHECK(m.volume == Approx(1920).epsilon(0.05));
    CHECK(m.high.y == Approx(4).margin(0.25)); // its face, at the origin, points down
    CHECK(m.low.y == Approx(0).margin(0.25));
}

TEST_CASE("the classic metal's mesh is closed and in metres", "[training]") {
    Lesson lesson = findLesson("classic", test::testFolder().parent_path() / "app" / "data" / "lessons");
    lesson.setup.particles = 2744;
    lesson.metal.supportRadius = 0.1F;
    lesson.surface.cells = 16;
    const Trainer trainer(test::shaders(), lesson);
    const MeshCopy mesh = bodiesOf(trainer);
    REQUIRE_FALSE(mesh.indices.empty());
    CHECK(isClosed(mesh));
    const Measures m = measure(mesh);
    CHECK(m.volume > 0);
    CHECK(m.high.x - m.low.x > 10); // a cube of some centimetres
    CHECK(m.high.x - m.low.x < 100);
}

TEST_CASE("the grid of the mesh follows the particles and stays within memory", "[training]") {
    const SurfaceParameters small = bodySurface(0.001F, glm::vec3(0), glm::vec3(0.035F, 0.014F, 0.028F));
    CHECK(small.cells == 50);
    CHECK(small.kernel == static_cast<int>(SurfaceKernel::smooth));
    CHECK(small.caps);
    const SurfaceParameters large = bodySurface(0.0002F, glm::vec3(0), glm::vec3(0.4F, 0.1F, 0.4F));
    const SurfaceGrid grid(large.cells, glm::vec3(0), glm::vec3(0.4F, 0.1F, 0.4F));
    CHECK(static_cast<double>(grid.blockCount()) * SURFACE_BLOCK_CORNERS < 40e6);
}
