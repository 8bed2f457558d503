// Soapstone marks at a joint: on the faces at both sides of each end of the length that counts.
#include "core/scene/joint_marks.hpp"

#include "core/render/solid_meshes.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <span>

using namespace meltpool;

namespace {

constexpr float kOnFace = 0.2e-3F; ///< m
constexpr size_t kMarks = 4, kArrow = 3;

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
    const auto all = jointMarks(endsOf({0, 1, 0}), plates);
    REQUIRE(all.size() == kMarks + kArrow);
    const std::span marks = std::span(all).first(kMarks);
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
    const auto all = jointMarks(endsOf({0, half, half}), plates);
    REQUIRE(all.size() == kMarks + kArrow);
    const std::span marks = std::span(all).first(kMarks);
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
    REQUIRE(marks.size() == kMarks + kArrow);
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
    CHECK(jointMarks(endsOf({0, 1, 0}), narrow).size() == 2 + kArrow);
    const auto onPipe = jointMarks(endsOf({0, 1, 0}), {});
    REQUIRE(onPipe.size() == kMarks + kArrow);
    CHECK(std::abs(middleOf(onPipe[0]).z) == Approx(0.0085F));
}

TEST_CASE("an arrow at the first end points along the line, on the welder's side if that has a face", "[scene]") {
    const std::array<WorkpieceBlock, 1> wide{{{{-0.03F, -0.003F, -0.02F}, {0.03F, 0, 0.02F}}}},
        far{{{{-0.03F, -0.003F, -0.02F}, {0.03F, 0, 0.006F}}}},
        shorter{{{{-0.03F, -0.003F, -0.02F}, {-0.01F, 0, 0.02F}}}};
    const auto arrowOn = [](std::span<const WorkpieceBlock> blocks) {
        const auto marks = jointMarks(endsOf({0, 1, 0}), blocks);
        return std::vector<Solid>(marks.size() > kArrow ? marks.end() - kArrow : marks.begin(), marks.end());
    };
    const std::vector<Solid> arrow = arrowOn(wide);
    REQUIRE(arrow.size() == kArrow);
    CHECK(middleOf(arrow[0]).z == Approx(0.0085F));
    const glm::vec3 shaft(arrow[0].toWorld[0]);
    CHECK(glm::normalize(shaft).x == Approx(1)); // from x = -12 mm to 12 mm
    const float tip = middleOf(arrow[0]).x + shaft.x / 2;
    for (size_t i = 1; i < kArrow; ++i) { // barbs lie behind the tip, at both sides
        CHECK(middleOf(arrow[i]).x < tip);
        CHECK(middleOf(arrow[i]).x > middleOf(arrow[0]).x - 1e-3F);
    }
    CHECK((middleOf(arrow[1]).z - 0.0085F) * (middleOf(arrow[2]).z - 0.0085F) < 0);
    CHECK(middleOf(arrowOn(far)[0]).z == Approx(-0.0085F));
    for (const Solid& mark : jointMarks(endsOf({0, 1, 0}), shorter)) // a plate that ends before the arrow does
        CHECK(std::abs(middleOf(mark).x + 0.012F) < 1e-5F);
}
