// Places and directions of seams against manual geometry.
#include "core/training/judging/seam.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using namespace meltpool;

namespace {

constexpr double kNear = 1e-12;

void checkVector(const glm::dvec3& value, const glm::dvec3& expected) {
    INFO(value.x << " " << value.y << " " << value.z);
    CHECK(glm::length(value - expected) < kNear);
}

Seam seamOfKind(WorkpieceKind kind) {
    WorkpieceParameters workpiece;
    workpiece.kind = static_cast<int>(kind);
    return seamOf(workpiece);
}

} // namespace

TEST_CASE("a joint's seam has its places along x and its bisector out of the joint", "[training][technique]") {
    for (const WorkpieceKind kind : {WorkpieceKind::Plate, WorkpieceKind::Bridge, WorkpieceKind::Butt}) {
        const Seam seam = seamOfKind(kind);
        CHECK(seam.begin() == Approx(-0.05));
        CHECK(seam.end() == Approx(0.05));
        checkVector(seam.at(0.02).point, {0.02, 0, 0});
        checkVector(seam.at(0.02).up, {0, 1, 0});
        checkVector(seam.at(0.02).across, {0, 0, 1});
    }
    const double half = std::numbers::sqrt2 / 2;
    for (const WorkpieceKind kind : {WorkpieceKind::Tee, WorkpieceKind::Lap}) {
        const SeamFrame frame = seamOfKind(kind).at(-0.01);
        checkVector(frame.point, {-0.01, 0, 0});
        checkVector(frame.tangent, {1, 0, 0});
        checkVector(frame.up, {0, half, half});
        checkVector(frame.across, {0, -half, half});
    }
    checkVector(seamOfKind(WorkpieceKind::Cube).at(0).point, {0, 0.05, 0});
}

TEST_CASE("the nearest place of a straight seam takes a point apart into place, offset and height",
          "[training][technique]") {
    const Seam seam = Seam::line({0.1, 0.2, 0.3}, {0, 0, 2}, {3, 4, 5}, -1, 1);
    const SeamFrame frame = seam.at(0.25);
    checkVector(frame.tangent, {0, 0, 1});
    checkVector(frame.up, {0.6, 0.8, 0});
    checkVector(frame.across, glm::cross(frame.tangent, frame.up));
    const SeamPlace place = seam.nearest(frame.point + 0.003 * frame.across + 0.007 * frame.up);
    CHECK(std::abs(place.place - 0.25) < kNear);
    CHECK(std::abs(place.across - 0.003) < kNear);
    CHECK(std::abs(place.height - 0.007) < kNear);
    CHECK_FALSE(seam.closed());
}

TEST_CASE("a circular seam runs once around its axis", "[training][technique]") {
    // The pipe runs along z with a radius of 60 mm: over the top towards +x, the welder's side positive.
    const Seam seam = Seam::circle({0, -0.06, 0.01}, {0, 0, -1}, {0, 0, 0});
    CHECK(seam.closed());
    CHECK(seam.length() == Approx(2 * std::numbers::pi * 0.06));
    checkVector(seam.at(0).point, {0, 0, 0});
    checkVector(seam.at(0).tangent, {1, 0, 0});
    checkVector(seam.at(0).up, {0, 1, 0});
    checkVector(seam.at(0).across, {0, 0, 1});
    const SeamFrame quarter = seam.at(seam.length() / 4);
    checkVector(quarter.point, {0.06, -0.06, 0});
    checkVector(quarter.tangent, {0, -1, 0});
    checkVector(quarter.up, {1, 0, 0});
    checkVector(quarter.across, {0, 0, 1});
    for (const double turn : {0.1, 0.45, 0.7, 0.99}) {
        const double at = turn * seam.length();
        const SeamFrame frame = seam.at(at + seam.length());
        const SeamPlace place = seam.nearest(frame.point - 0.002 * frame.across + 0.004 * frame.up);
        CHECK(std::abs(place.place - at) < kNear);
        CHECK(std::abs(place.across + 0.002) < kNear);
        CHECK(std::abs(place.height - 0.004) < kNear);
    }
}

TEST_CASE("an outside corner's seam looks out between its edges, a pipe's once around its outer face",
          "[training][technique]") {
    const double half = std::numbers::sqrt2 / 2;
    const SeamFrame corner = seamOfKind(WorkpieceKind::Corner).at(0.01);
    checkVector(corner.point, {0.01, 0, 0});
    checkVector(corner.up, {0, half, half});
    WorkpieceParameters pipe;
    pipe.kind = static_cast<int>(WorkpieceKind::Pipe);
    pipe.diameterMm = 80;
    const Seam seam = seamOf(pipe);
    CHECK(seam.closed());
    CHECK(seam.length() == Approx(std::numbers::pi * 0.08));
    checkVector(seam.at(0).point, {0, 0, 0});
    checkVector(seam.at(0).tangent, {1, 0, 0});
    checkVector(seam.at(0).across, {0, 0, 1});
    CHECK(glm::length(seam.at(seam.length() / 2).point - glm::dvec3(0, -0.08, 0)) < 1e-8);
}
