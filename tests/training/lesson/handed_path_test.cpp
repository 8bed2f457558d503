// A lesson's demonstration for either hand: the direction, and a mirror image with equal figures.
#include "core/training/lesson/handed_path.hpp"

#include "core/training/feedback/ghost.hpp"
#include "core/training/judging/seam.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <glm/geometric.hpp>

#include <string>

using namespace meltpool;

namespace {

Lesson shipped(const std::string& name) {
    return readLesson(test::sourceFolder() / "app" / "data" / "lessons" / (name + ".toml"));
}

} // namespace

TEST_CASE("a right hand pushes from right to left and drags from left to right, a left hand the other way",
          "[training][path]") {
    const auto direction = [](const char* lesson, WeldingHand hand) { return directionForHand(shipped(lesson), hand); };
    for (const char* pushes : {"gtaw-bead", "gtaw-butt", "tee-fillet"}) {
        INFO(pushes);
        CHECK(direction(pushes, WeldingHand::right) == -1);
        CHECK(direction(pushes, WeldingHand::left) == 1);
    }
    CHECK(direction("smaw-bead", WeldingHand::right) == 1);
    CHECK(direction("smaw-bead", WeldingHand::left) == -1);
    // A seam up a wall or round a pipe leaves no choice, nor a lesson without technique.
    for (const char* fixed : {"tee-3f", "pipe-5g", "solder-cube", "classic"})
        CHECK(direction(fixed, WeldingHand::right) == 0);
    Lesson upright = shipped("gtaw-bead");
    for (TechniqueBand& band : upright.technique->bands)
        if (band.quantity == TechniqueQuantity::travelAngle) band.ideal = 0;
    CHECK(directionForHand(upright, WeldingHand::right) == 0);
}

TEST_CASE("the mirrored path is held, fed and led as the lesson's own, towards the other end", "[training][path]") {
    const Lesson lesson = shipped(GENERATE("gtaw-rod", "gtaw-butt", "tee-fillet"));
    const TorchPath left = pathForHand(lesson, WeldingHand::left), right = pathForHand(lesson, WeldingHand::right);
    const Seam seam = seamOf(lesson.workpiece);
    CHECK(left.duration() == right.duration());
    CHECK(left.firstPull() == right.firstPull());
    const auto ends = static_cast<float>(seam.begin() + seam.end());
    for (double time = 0; time < left.duration(); time += 0.37) {
        const TorchSample a = left.sample(time), b = right.sample(time);
        REQUIRE(b.tip.x == Approx(ends - a.tip.x).margin(1e-6));
        REQUIRE(b.tip.y == a.tip.y);
        REQUIRE(b.tip.z == a.tip.z);
        REQUIRE(b.trigger == a.trigger);
        REQUIRE(glm::distance(b.axis(), a.axis() * glm::vec3(-1, 1, 1)) < 1e-5f);
        REQUIRE(a.rod.has_value() == b.rod.has_value());
        if (!a.rod) continue;
        REQUIRE(b.rod->feed == a.rod->feed);
        REQUIRE(glm::distance(b.rod->axis(), a.rod->axis() * glm::vec3(-1, 1, 1)) < 1e-5f);
    }
    // A hand's measures do not tell one from the other, except for the direction.
    const GhostPath one(left, seam, lesson.technique->settings()), other(right, seam, lesson.technique->settings());
    CHECK(one.direction() == 1);
    CHECK(other.direction() == -1);
    CHECK(one.duration() == Approx(other.duration()));
    const auto there = one.atTime(one.duration() / 2), image = other.atTime(other.duration() / 2);
    REQUIRE((there && image));
    CHECK(image->speed == Approx(there->speed).epsilon(1e-3));
    CHECK(image->travelAngle == Approx(there->travelAngle).margin(1e-3));
    CHECK(image->workAngle == Approx(there->workAngle).margin(1e-3));
}

TEST_CASE("the mirror image of a mirror image is the path, bit by bit", "[training][path]") {
    const TorchPath path = shipped("gtaw-rod").torch, same = path.mirrored(0.004).mirrored(0.004);
    for (double time = 0; time < path.duration(); time += 0.37) {
        CHECK(same.sample(time).tip == path.sample(time).tip);
        CHECK(same.sample(time).orientation == path.sample(time).orientation);
    }
}
