// The camera at a lesson's start: seam and torch of every lesson are in the part of the window that no panel covers.
#include "app/session/start_camera.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/training/trainer/classic_model.hpp"
#include "core/weld/workpiece/position.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <glm/vec4.hpp>

#include <algorithm>
#include <filesystem>

namespace meltpool {

namespace {

/// Window with the bars above and below and the machine's values at the right.
struct PanelledWindow {
    glm::vec2 size;
    float text;

    float aspect() const { return size.x / size.y; }
    CoveredEdges covered() const {
        const float panel = 346 * text / size.x, bar = 48 * text / size.y;
        return {0, panel < 0.7f ? panel : 0, bar, bar};
    }
};

constexpr PanelledWindow kWindows[] = {{{800, 600}, 1},  {{800, 600}, 2},   {{1280, 720}, 1},
                                       {{1280, 720}, 2}, {{3840, 2160}, 1}, {{3840, 2160}, 2}};

/// True if the point is in the uncovered part of the window's picture.
bool isUncovered(const Controls& controls, const PanelledWindow& window, const glm::vec3& point) {
    const CoveredEdges covered = window.covered();
    const View view = controls.view(window.aspect());
    const glm::vec4 clip = view.eyeToClip * view.worldToEye * glm::vec4(point, 1);
    const float x = (clip.x / clip.w + covered.shift() + 1) / 2, y = (clip.y / clip.w + 1) / 2;
    return clip.w > 0 && x > covered.left && x < 1 - covered.right && y > covered.bottom && y < 1 - covered.top;
}

} // namespace

TEST_CASE("seam and torch of every lesson begin in the part of the window that no panel covers") {
    int lessons = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::sourceFolder() / "app" / "data" / "lessons")) {
        if (entry.path().extension() != ".toml") continue;
        const Lesson lesson = readLesson(entry.path());
        DeskTorch torch;
        torch.begin(lesson);
        for (const PanelledWindow& window : kWindows) {
            INFO(entry.path().filename() << " at " << window.size.x << " x " << window.size.y << ", text "
                                         << window.text);
            Controls controls;
            StartCamera camera;
            camera.begin(controls, lesson, torch);
            camera.frame(controls, window.covered(), window.aspect());
            for (const glm::vec3& point : pointsToShow(lesson, torch))
                CHECK(isUncovered(controls, window, point));
            // With the torch put aside the picture moves less.
            StartCamera aside;
            Controls without;
            aside.begin(without, lesson, torch);
            aside.frame(without, window.covered(), window.aspect(), false);
            CHECK(without.orbitCamera().distance() <= controls.orbitCamera().distance());
            if (!lesson.technique || static_cast<WorkpieceKind>(lesson.workpiece.kind) == WorkpieceKind::Pipe) continue;
            // A weld runs on past the counted length.
            const Seam seam = seamOf(lesson.workpiece);
            const double end = std::min(seam.end(), lesson.technique->lengthToMm * 1e-3 + 5e-3);
            const glm::vec3 runOn = fixtureOf(lesson.workpiece).turn * glm::vec3(seam.at(end).point) / kClassicUnit;
            CHECK(isUncovered(controls, window, runOn));
        }
        ++lessons;
    }
    CHECK(lessons > 10);
}

TEST_CASE("the camera of a lesson stays where its picture has room, and where the person has moved it") {
    const Lesson lesson = findLesson("gmaw-bead", test::sourceFolder() / "app" / "data" / "lessons");
    DeskTorch torch;
    torch.begin(lesson);
    Controls controls;
    StartCamera camera;
    camera.begin(controls, lesson, torch);
    const OrbitCamera asked = controls.orbitCamera();
    CHECK(asked.distance() == lesson.camera.distance);
    const PanelledWindow narrow{{800, 600}, 1};
    camera.frame(controls, narrow.covered(), narrow.aspect());
    CHECK(controls.orbitCamera() != asked);
    CHECK(controls.orbitCamera().distance() >= asked.distance());
    CHECK(controls.orbitCamera().azimuth() == asked.azimuth());

    controls.placeCamera(OrbitCamera(0.1f, 0.2f, 1));
    camera.frame(controls, narrow.covered(), narrow.aspect());
    CHECK(controls.orbitCamera() == OrbitCamera(0.1f, 0.2f, 1));
}

} // namespace meltpool
