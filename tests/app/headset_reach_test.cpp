// Checks the places of the work in the headset: in reach and sight of persons of any size, in every shipped lesson.
#include "app/headset/workshop.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <cmath>
#include <filesystem>
#include <vector>

using namespace meltpool;

namespace {

/// Heights of the eyes over the floor, m: persons of 1.55, 1.75 and 1.95 m who stand, and of 1.55 and 1.95 m on a
/// chair.
constexpr float kEyes[] = {1.44f, 1.63f, 1.83f, 1.10f, 1.32f};

/// Places on the seam in the workpiece's frame, m: both ends and the middle; on a pipe its top and the welder's side.
std::vector<glm::vec3> seamOf(const Workpiece& piece) {
    if (piece.pipe) {
        const glm::vec3 axis(piece.pipe->axis, 0);
        return {axis + glm::vec3(0, piece.pipe->outer, 0), axis + glm::vec3(piece.pipe->outer, 0, 0),
                axis - glm::vec3(piece.pipe->outer, 0, 0)};
    }
    return {{piece.bodyLow.x, 0, 0}, {0, 0, 0}, {piece.bodyHigh.x, 0, 0}};
}

} // namespace

TEST_CASE(
    "in every lesson the seam is 35 to 60 cm from the eyes of everybody who stands or sits upright, and they look past "
    "the torch",
    "[app]") {
    size_t lessons = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::sourceFolder() / "app" / "data" / "lessons")) {
        if (entry.path().extension() != ".toml") continue;
        const Lesson lesson = readLesson(entry.path());
        if (lesson.model != LessonModel::Weld) continue;
        ++lessons;
        const Workpiece piece = makeWorkpiece(lesson.workpiece);
        for (const float eyes : kEyes) {
            const xr::Pose head{{1, 0, 0, 0}, {0.4f, eyes, -2}};
            Workshop workshop;
            const float table = workshop.place(head, std::nullopt, true);
            const Fixture fixture = beforeFace(fixtureOf(lesson.workpiece));
            const WorkpiecePlace place(table, 1, piece.floorHeight, fixture, stanceFor(fixture, lesson.torch));
            const glm::vec3 seen = workshop.toWorkshop(head).position;
            for (const glm::vec3& at : seamOf(piece)) {
                const float away = glm::distance(place.toWorkshop(at), seen);
                INFO(entry.path().filename() << ", eyes at " << eyes << " m, seam at " << at.x << ' ' << at.y);
                CHECK(away > 0.35f);
                CHECK(away < 0.60f);
            }
            const double welding = lesson.torch.firstPull().value() + 0.5;
            const TorchSample torch = lesson.torch.sample(welding);
            const glm::vec3 back = -(place.turn * torch.axis());
            const glm::vec3 sight = glm::normalize(seen - place.toWorkshop(torch.tip));
            INFO(entry.path().filename() << ", eyes at " << eyes << " m");
            CHECK(glm::degrees(std::acos(glm::dot(back, sight))) > 38);
        }
    }
    CHECK(lessons > 8);
}

TEST_CASE("a workpiece whose torch leans to the eyes is turned, with its matrix; others lie straight", "[app]") {
    const auto stanceOf = [](const char* name) {
        const Lesson lesson =
            readLesson(test::sourceFolder() / "app" / "data" / "lessons" / (std::string(name) + ".toml"));
        return stanceFor(beforeFace(fixtureOf(lesson.workpiece)), lesson.torch);
    };
    CHECK(stanceOf("gmaw-bead").turned == 0);
    const Stance tee = stanceOf("tee-fillet");
    CHECK(glm::degrees(tee.turned) > 10);
    CHECK(tee.aside > 0.05f);
    const WorkpiecePlace place(0.9f, 2, 0, {}, tee);
    const glm::vec3 right = place.toWorkshop({0.1f, 0, 0}) - place.toWorkshop({0, 0, 0});
    CHECK(right.z > 0.02f); // nearer to the person
    CHECK(glm::length(right) == Approx(0.2f));
    CHECK(glm::distance(place.toWorkpiece(place.toWorkshop({0.01f, 0.02f, 0.03f})), glm::vec3(0.01f, 0.02f, 0.03f)) <
          1e-5f);
    const glm::vec3 drawn(place.modelToWorkshop(1) * glm::vec4(0.1f, 0, 0, 1));
    CHECK(glm::distance(drawn, place.toWorkshop({0.1f, 0, 0})) < 1e-5f);
}
