#include "app/headset/workshop.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace meltpool {

namespace {

/// Turn about the vertical that brings -Z to the direction of `orientation`; for straight up or down, to the direction
/// of its top.
float yawOf(const glm::quat& orientation) {
    glm::vec3 forward = orientation * glm::vec3(0, 0, -1);
    if (std::abs(forward.y) > 0.99f) forward = orientation * glm::vec3(0, forward.y > 0 ? -1 : 1, 0);
    return std::atan2(-forward.x, -forward.z);
}

} // namespace

void Workshop::recentre(const xr::Pose& head, const HeadsetParameters& parameters, bool floorKnown) {
    const glm::quat back = glm::angleAxis(-yawOf(head.orientation), glm::vec3(0, 1, 0));
    glm::vec3 eyes(0, head.position.y, kReach); // wanted place of the head in the workshop
    if (parameters.posture == HeadsetParameters::kSeated || !floorKnown) eyes.y = parameters.tableHeight + kSeatedDrop;
    sessionToWorkshop_ = {back, eyes - back * head.position};
    recentreRequested_ = false;
}

WorkpiecePlace::WorkpiecePlace(float tableHeight, float theZoom, float bottom, const Fixture& held)
    : origin(0, tableHeight + held.overTable - bottom * theZoom, 0), zoom(theZoom), turn(held.turn) {}

glm::mat4 WorkpiecePlace::modelToWorkshop(float unit) const {
    return glm::scale(glm::translate(glm::mat4(1.0f), origin), glm::vec3(unit * zoom));
}

} // namespace meltpool
