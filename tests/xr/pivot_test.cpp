// Tests pivot calibration on synthetic poses, and its file.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "xr/pivot.hpp"

#include <glm/gtx/quaternion.hpp>

#include <random>

using namespace meltpool;

namespace {

struct Swing {
    float tilt = 0.8f;  ///< rad, to all sides
    float twist = 0.8f; ///< rad, about the torch's axis
    float noise = 0.0f; ///< standard deviation of each coordinate, m
    int count = 600;    ///< ten seconds at 60 Hz
};

constexpr glm::vec3 kOffset(0.013f, -0.041f, -0.187f);
constexpr glm::vec3 kPoint(0.22f, 0.91f, -0.35f);

/// Makes grip poses of a torch whose tip stays on kPoint.
std::vector<xr::Pose> swing(const Swing& how, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal(0.0f, 1.0f);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    std::vector<xr::Pose> poses;
    for (int i = 0; i < how.count; ++i) {
        const glm::quat q = glm::normalize(glm::angleAxis(how.tilt * uniform(random), glm::vec3(1, 0, 0)) *
                                           glm::angleAxis(how.tilt * uniform(random), glm::vec3(0, 1, 0)) *
                                           glm::angleAxis(how.twist * uniform(random), glm::vec3(0, 0, 1)));
        const glm::vec3 wobble = how.noise * glm::vec3(normal(random), normal(random), normal(random));
        poses.push_back({q, kPoint - q * kOffset + wobble});
    }
    return poses;
}

} // namespace

TEST_CASE("exact poses give the offset and the point exactly") {
    const xr::PivotResult result = xr::solvePivot(swing({}, 1));
    REQUIRE(result.accepted);
    CHECK(glm::distance(result.offset, kOffset) < 1e-5f);
    CHECK(glm::distance(result.point, kPoint) < 1e-5f);
    CHECK(result.residualMm < 0.01f);
}

TEST_CASE("poses with 1 mm of noise find the offset within 0.3 mm") {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        const xr::PivotResult result = xr::solvePivot(swing({.noise = 0.001f}, seed));
        REQUIRE(result.accepted);
        CHECK(glm::distance(result.offset, kOffset) < 0.0003f);
        // Three noisy coordinates: the square root of 3 times 1 mm.
        CHECK(result.residualMm == Approx(1.732f).epsilon(0.1));
    }
}

TEST_CASE("poses that do not turn enough are refused") {
    const bool still = GENERATE(true, false);
    // The torch does not turn, or turns about one axis only: the offset along that axis stays free.
    const Swing how =
        still ? Swing{.tilt = 0.0f, .twist = 0.0f, .noise = 0.001f} : Swing{.tilt = 0.0f, .noise = 0.001f};
    const xr::PivotResult result = xr::solvePivot(swing(how, 7));
    CHECK_FALSE(result.accepted);
    CHECK_THAT(result.reason, test::containsText("turn"));
}

TEST_CASE("too few poses and a sliding tip are refused") {
    CHECK_THAT(xr::solvePivot(swing({.count = 5}, 3)).reason, test::containsText("5 poses"));
    const xr::PivotResult slid = xr::solvePivot(swing({.noise = 0.01f}, 3));
    CHECK_FALSE(slid.accepted);
    CHECK_THAT(slid.reason, test::containsText("slid"));
}

TEST_CASE("a calibration survives its file, and a broken file is told by line") {
    const std::filesystem::path file = test::scratchFolder("pivot") / "torch.txt";
    xr::TipCalibration written;
    written.offset = kOffset;
    written.orientation = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    written.residualMm = 0.4f;
    xr::writeCalibration(file, written);
    const xr::TipCalibration read = xr::readCalibration(file);
    CHECK(glm::distance(read.offset, kOffset) < 1e-6f);
    CHECK(std::abs(glm::dot(read.orientation, written.orientation)) > 0.999999f);
    CHECK(read.residualMm == Approx(0.4f));

    writeTextFileAtomically(file, "x_mm = 1\ny_mm = two\n");
    CHECK_THROWS_WITH(xr::readCalibration(file), test::containsText(":2: "));
    writeTextFileAtomically(file, "x_mm = 1\n");
    CHECK_THROWS_WITH(xr::readCalibration(file), test::containsText("y_mm"));
    for (const char* far : {"x_mm = 1e300", "x_mm = -2001", "qx = 7", "residual_mm = -1"}) {
        writeTextFileAtomically(file, std::string("# a tip\n") + far + "\n");
        CHECK_THROWS_WITH(xr::readCalibration(file), test::containsText(":2: ") && test::containsText("out of range") &&
                                                         test::containsText("expected a number from"));
    }
}

TEST_CASE("the standard error that is told is the error that is made") {
    double squares = 0;
    constexpr int kSeeds = 200;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        const xr::PivotResult result = xr::solvePivot(swing({.noise = 0.001f, .count = 300}, seed));
        REQUIRE(result.accepted);
        const double ratio = 1000.0 * double(glm::distance(result.offset, kOffset)) / double(result.errorMm);
        squares += ratio * ratio;
    }
    CHECK(std::sqrt(squares / kSeeds) == Approx(1).epsilon(0.15));
}

TEST_CASE("twelve seconds at 90 Hz find the offset within 0.3 mm for every seed, by a margin") {
    float worst = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const xr::PivotResult result = xr::solvePivot(swing({.noise = 0.001f, .count = 1080}, seed));
        REQUIRE(result.accepted);
        worst = std::max(worst, 1000.0f * glm::distance(result.offset, kOffset));
    }
    CHECK(worst < 0.25f);
}

TEST_CASE("an offset that the noise leaves uncertain is refused and says by how much") {
    const xr::PivotResult result = xr::solvePivot(swing({.tilt = 0.4f, .noise = 0.0015f, .count = 60}, 2));
    CHECK_FALSE(result.accepted);
    CHECK(result.errorMm > xr::kPivotError);
    CHECK_THAT(result.reason, test::containsText("only known to"));
    CHECK(xr::solvePivot(swing({.tilt = 0.4f, .noise = 0.0015f, .count = 1080}, 2)).accepted);
}

TEST_CASE("a torch held tip down tells the way it points, whatever way round it is held") {
    const glm::vec3 points = glm::normalize(glm::vec3(0.3f, -0.5f, -0.8f)); // direction in the grip's frame
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    std::vector<xr::Pose> poses;
    const glm::quat upright = glm::rotation(points, glm::vec3(0, -1, 0));
    for (int i = 0; i < 200; ++i) {
        const glm::quat tremble = glm::angleAxis(0.02f * normal(random), glm::vec3(1, 0, 0)) *
                                  glm::angleAxis(0.02f * normal(random), glm::vec3(0, 0, 1));
        poses.push_back({tremble * glm::angleAxis(0.03f * float(i), glm::vec3(0, 1, 0)) * upright, {0, 1, 0}});
    }
    const xr::AxisResult found = xr::solveAxis(poses);
    REQUIRE(found.accepted);
    CHECK(glm::distance(found.direction, points) < 0.005f);
    CHECK(found.spreadDegrees == Approx(glm::degrees(0.02f * std::sqrt(2.0f))).epsilon(0.15));
    xr::TipCalibration calibration;
    calibration.offset = kOffset;
    calibration.pointAlong(found.direction);
    const xr::Pose tip = calibration.tip(poses[0]);
    CHECK(tip.forward().y < -0.99f);
    CHECK(glm::distance(tip.position, poses[0] * kOffset) < 1e-6f);

    CHECK_THAT(xr::solveAxis(std::span(poses).first(5)).reason, test::containsText("5 poses"));
    poses[3].orientation = glm::angleAxis(1.5f, glm::vec3(1, 0, 0)) * poses[3].orientation;
    const xr::AxisResult swung = xr::solveAxis(poses);
    CHECK_FALSE(swung.accepted);
    CHECK_THAT(swung.reason, test::containsText("still"));
}
