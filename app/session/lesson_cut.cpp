// The part of LessonSession that cuts the weld open, moves the cut and puts the camera before it.
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

bool LessonSession::cuts() const {
    return judges() && (!arc().burns() || paused_) && !question_.asked() && fault_.empty() &&
           CutView::canCut(trainer_->lesson());
}

void LessonSession::toggleCut(Controls& controls) {
    if (cut_.shown()) return closeCut(controls);
    if (!cuts()) return;
    cameraBeforeCut_ = controls.orbitCamera();
    modeBeforeCut_ = controls.mode();
    try {
        cut_.open(*trainer_, judge_);
    } catch (const RuntimeFault& fault) {
        cut_.close();
        fault_ = fault.what();
        return;
    }
    controls.setMode(Mode::interact);
    controls.putOut(ArcOut::paused);
    placeCameraBeforeCut(controls);
    event("cut", "open");
}

void LessonSession::closeCut(Controls& controls) {
    if (!cut_.shown()) return;
    cut_.close();
    controls.placeCamera(cameraBeforeCut_);
    controls.setMode(modeBeforeCut_);
    controls.putOut(ArcOut::paused);
    event("cut", "closed");
}

/// Square before the cut, on the side that is taken away, at a distance from which all measures are seen. A seam that
/// stands upright is looked at from above, turned so that the workpiece's own y points up in the picture.
void LessonSession::placeCameraBeforeCut(Controls& controls) const {
    constexpr float kUpright = 0.99f; // of the way to the camera
    constexpr double kPicture = 4.2;  // height of the picture in extents of the measures
    const glm::mat3 turn = fixture().turn;
    const glm::vec3 way = turn * glm::vec3(1, 0, 0), up = turn * glm::vec3(0, 1, 0);
    float azimuth = std::atan2(way.x, way.z);
    if (std::abs(way.y) > kUpright) azimuth = way.y > 0 ? std::atan2(-up.x, -up.z) : std::atan2(up.x, up.z);
    const auto height = static_cast<float>(kPicture * cut_.extent()) / unit();
    const float distance = 0.5f * height / std::tan(0.5f * controls.lens.fieldOfView);
    controls.placeCamera(OrbitCamera(azimuth, std::asin(std::clamp(way.y, -1.0f, 1.0f)), distance));
}

/// Moves the cut by what the hand does in this frame, and cuts where it is now.
void LessonSession::inspect(const Controls& controls) {
    constexpr double kArrow = 1e-3, kPoint = 0.1e-3; // m an arrow key, a point of the mouse's way
    const InputFrame& hand = controls.hand();
    double way = kPoint * static_cast<double>(hand.dragMove.x);
    for (const Key key : hand.pressed)
        way += kArrow * ((key == Key::right) - (key == Key::left));
    if (controls.mode() == Mode::interact) cut_.moveTo(cut_.place() + way);
    try {
        cut_.update(*trainer_, judge_);
    } catch (const RuntimeFault& fault) {
        fault_ = fault.what();
    }
}

} // namespace meltpool
