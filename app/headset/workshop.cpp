#include "app/headset/workshop.hpp"

#include "core/scene/workshop_furniture.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
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

float Workshop::place(const xr::Pose& head, std::optional<float> setHeight, bool floorKnown) {
    const glm::quat back = glm::angleAxis(-yawOf(head.orientation), glm::vec3(0, 1, 0));
    float table = setHeight.value_or(kUsualTableHeight);
    if (!setHeight && floorKnown) table = std::clamp(head.position.y - kDrop, kLowest, kHighest);
    // Wanted place of the head in the workshop; without a known floor the table comes to the person.
    const glm::vec3 eyes(0, floorKnown ? head.position.y : table + kDrop, kReach);
    sessionToWorkshop_ = {back, eyes - back * head.position};
    return table;
}

Fixture beforeFace(const Fixture& held) {
    constexpr float kVertical = 0.18f, kPipe = 0.22f, kOverhead = 0.58f; // m over the table
    const bool overhead = held.turn[1].y<-0.5f, upright = std::abs(held.turn[0].y)> 0.5f;
    Fixture fixture = held;
    if (overhead)
        fixture.overTable = kOverhead;
    else if (upright)
        fixture.overTable = kVertical;
    else if (held.overTable > 0)
        fixture.overTable = kPipe;
    return fixture;
}

WorkpiecePlace::WorkpiecePlace(float tableHeight, float theZoom, float bottom, const Fixture& held)
    : origin(0, tableHeight + held.overTable - bottom * theZoom, 0),
      zoom(theZoom),
      overTable(held.overTable),
      turn(held.turn) {}

glm::mat4 WorkpiecePlace::modelToWorkshop(float unit) const {
    return glm::scale(glm::translate(glm::mat4(1.0f), origin), glm::vec3(unit * zoom));
}

} // namespace meltpool
