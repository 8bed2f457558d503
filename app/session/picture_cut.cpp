// The part of LessonPicture that cuts the weld open, moves the cut and puts the camera before it.
#include "app/session/lesson_picture.hpp"
#include "core/base/error.hpp"
#include "core/training/trainer/classic_model.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

void LessonPicture::openCut(Controls& controls) {
    cameraBeforeCut_ = controls.orbitCamera();
    modeBeforeCut_ = controls.mode();
    try {
        cut_.open(*trainer(), source_.activities.attempt.judging());
    } catch (const RuntimeFault&) {
        cut_.close();
        throw;
    }
    controls.setMode(Mode::interact);
    controls.putOut(ArcOut::paused);
    placeCameraBeforeCut(controls);
}

bool LessonPicture::closeCut(Controls& controls) {
    if (!cut_.shown()) return false;
    cut_.close();
    controls.placeCamera(cameraBeforeCut_);
    controls.setMode(modeBeforeCut_);
    controls.putOut(ArcOut::paused);
    return true;
}

/// Places the camera square before the cut, on the removed side, at a distance from which all measures are visible. An
/// upright seam is viewed from above, turned so that the workpiece's y points up in the picture.
void LessonPicture::placeCameraBeforeCut(Controls& controls) const {
    constexpr float kUpright = 0.99f; // cosine towards the vertical
    constexpr double kPicture = 4.2;  // height of the picture in extents of the measures
    const glm::mat3 turn = fixture().turn;
    const glm::vec3 way = turn * glm::vec3(1, 0, 0), up = turn * glm::vec3(0, 1, 0);
    float azimuth = std::atan2(way.x, way.z);
    if (std::abs(way.y) > kUpright) azimuth = way.y > 0 ? std::atan2(-up.x, -up.z) : std::atan2(up.x, up.z);
    const auto height = static_cast<float>(kPicture * cut_.extent()) / kClassicUnit;
    const float distance = 0.5f * height / std::tan(0.5f * controls.lens.fieldOfView);
    controls.placeCamera(OrbitCamera(azimuth, std::asin(std::clamp(way.y, -1.0f, 1.0f)), distance));
}

void LessonPicture::moveCut(const Controls& controls) {
    constexpr double kArrow = 1e-3, kPoint = 0.1e-3; // m per arrow key, and per point of mouse travel
    const InputFrame& hand = controls.hand();
    double way = kPoint * static_cast<double>(hand.dragMove.x);
    for (const Key key : hand.pressed)
        way += kArrow * ((key == Key::right) - (key == Key::left));
    if (controls.mode() == Mode::interact) cut_.moveTo(cut_.place() + way);
    cut_.update(*trainer(), source_.activities.attempt.judging());
}

/// Moves the middle of the cut to the point that the camera looks at.
void LessonPicture::standBeforeCut(SceneView& scene, View& view) {
    const glm::vec3 middle = scene.modelToWorld * glm::vec4(scene.section.at, 0, 0, 1);
    view.worldToEye = glm::translate(view.worldToEye, -middle);
    view.eye += middle;
    scene.section.strokes = cut_.strokes(layoutIn(view, scene.modelToWorld, scene.section.at));
    scene.room.shown = false; // shows only the cut metal
}

} // namespace meltpool
