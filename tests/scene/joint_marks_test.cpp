// Soapstone marks at a joint: on the faces at both sides of each end of the length that counts.
#include "core/scene/joint_marks.hpp"

#include "core/render/solid_meshes.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>

using namespace meltpool;

namespace {

constexpr float kOnFace = 0.2e-3F; ///< m

/// Ends at x = -12 and 12 mm of a seam along x that opens to `up`.
std::array<JointEnd, 2> endsOf(const glm::vec3& up) {
    const glm::vec3 across = glm::cross(glm::vec3(1, 0, 0), up);
    return {{{{-0.012F, 0, 0}, across, up}, {{0.012F, 0, 0}, across, up}}};
}

glm::vec3 middleOf(const Solid& solid) {
    return solid.toWorld[3];
}

/// Unit vector of the thin direction of a stroke.
glm::vec3 normalOf(const Solid& solid) {
    return glm::normalize(glm::vec3(solid.toWorld[1]));
}

} // namespace

TEST_CASE("a butt joint has marks on both plates, at both ends", "[scene]") {
    const std::array<WorkpieceBlock, 2> plates{
        {{{-0.03F, -0.003F, -0.02F}, {0.03F, 0, -0.0004F}}, {{-0.03F, -0.003F, 0.0004F}, {0.03F, 0, 0.02F}}}};
    const auto marks = jointMarks(endsOf({0, 1, 0}), plates);
    REQUIRE(marks.size() == 4);
    for (const Solid& mark : marks) {
        CHECK(std::abs(middleOf(mark).x) == Approx(0.012F));
        CHECK(std::abs(middleOf(mark).z) == Approx(0.0085F));
        CHECK(normalOf(mark).y == Approx(1));
        CHECK(glm::length(glm::vec3(mark.toWorld[0])) == Approx(0.007F));
    }
    CHECK(middleOf(marks[0]).z == Approx(-middleOf(marks[1]).z));
}

TEST_CASE("a tee has its marks on the base plate and on the upright plate", "[scene]") {
    const std::array<WorkpieceBlock, 2> plates{
        {{{-0.03F, -0.004F, -0.02F}, {0.03F, 0, 0.02F}}, {{-0.03F, 0, -0.004F}, {0.03F, 0.02F, 0}}}};
    const float half = std::sqrt(0.5F);
    const auto marks = jointMarks(endsOf({0, half, half}), plates);
    REQUIRE(marks.size() == 4);
    int onBase = 0, onUpright = 0;
    for (const Solid& mark : marks) {
        const glm::vec3 middle = middleOf(mark), normal = normalOf(mark);
        if (normal.y > 0.99F) {
            ++onBase;
            CHECK(middle.y == Approx(0).margin(double(kOnFace)));
            CHECK(middle.z == Approx(0.0085F / half));
        } else {
            ++onUpright;
            CHECK(normal.z == Approx(1));
            CHECK(middle.z == Approx(0).margin(double(kOnFace)));
            CHECK(middle.y == Approx(0.0085F / half));
        }
    }
    CHECK(onBase == 2);
    CHECK(onUpright == 2);
}

TEST_CASE("a mark is a stroke of chalk on the face: thin, matt, ragged, and not up to the plate's edge", "[scene]") {
    const std::array<WorkpieceBlock, 1> plate{{{{-0.03F, -0.003F, -0.0095F}, {0.03F, 0, 0.02F}}}};
    const SolidMeshes meshes = makeSolidMeshes();
    const auto marks = jointMarks(endsOf({0, 1, 0}), plate);
    REQUIRE(marks.size() == 4);
    for (const Solid& mark : marks) {
        CHECK(mark.gloss == 0);
        CHECK(mark.colour.g > 0.7F);
        const SolidMeshes::Range range = meshes.shapes[static_cast<size_t>(mark.shape)];
        float area = 0; // less than that of its rectangle
        const auto at = [&](int i) {
            const SolidVertex& vertex = meshes.vertices[meshes.indices[static_cast<size_t>(range.first + i)]];
            return glm::vec3(mark.toWorld * glm::vec4(vertex.position, 1));
        };
        for (int i = 0; i < range.count; i += 3) {
            area += glm::length(glm::cross(at(i + 1) - at(i), at(i + 2) - at(i))) / 2;
            CHECK(at(i).y > 0);
            CHECK(at(i).y < kOnFace);
            CHECK(at(i).z > -0.009F);
        }
        const float whole = glm::length(glm::vec3(mark.toWorld[0])) * glm::length(glm::vec3(mark.toWorld[2]));
        CHECK(area > 0.6F * whole);
        CHECK(area < 0.95F * whole);
    }
}

TEST_CASE("there is no mark where there is no face, and a pipe's lie along its axis", "[scene]") {
    const std::array<WorkpieceBlock, 1> narrow{{{{-0.03F, -0.003F, -0.004F}, {0.03F, 0, 0.02F}}}};
    CHECK(jointMarks(endsOf({0, 1, 0}), narrow).size() == 2);
    const auto onPipe = jointMarks(endsOf({0, 1, 0}), {});
    REQUIRE(onPipe.size() == 4);
    CHECK(std::abs(middleOf(onPipe[0]).z) == Approx(0.0085F));
}
