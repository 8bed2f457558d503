// Checks the places of the work in the headset: in reach and sight of persons of any size, in every shipped lesson.
#include "app/headset/workshop.hpp"
#include "core/training/lesson/lesson.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

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

TEST_CASE("in every lesson the seam is 35 to 60 cm from the eyes of everybody who stands or sits upright", "[app]") {
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
            const WorkpiecePlace place(table, 1, piece.floorHeight, beforeFace(fixtureOf(lesson.workpiece)));
            const glm::vec3 seen = workshop.toWorkshop(head).position;
            for (const glm::vec3& at : seamOf(piece)) {
                const float away = glm::distance(place.toWorkshop(at), seen);
                INFO(entry.path().filename() << ", eyes at " << eyes << " m, seam at " << at.x << ' ' << at.y);
                CHECK(away > 0.35f);
                CHECK(away < 0.60f);
            }
        }
    }
    CHECK(lessons > 8);
}
