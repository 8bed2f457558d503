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

glm::mat3 turnOf(const Stance& stance) {
    return glm::mat3_cast(glm::angleAxis(-stance.turned, glm::vec3(0, 1, 0)));
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

Stance stanceFor(const Fixture& fixture, const TorchPath& demonstration) {
    constexpr double kWelding = 0.5;                   // s after the first pull
    constexpr float kHidden = 0.766f, kClear = 0.643f; // cosines of the least angles
    constexpr float kTurned = 0.436f, kAside = 0.12f;  // the greatest
    constexpr int kSteps = 5;
    const auto pull = demonstration.firstPull();
    if (!pull) return {};
    const glm::vec3 back = -(fixture.turn * demonstration.sample(*pull + kWelding).axis());
    const float way = back.x > 0 ? -1.0f : 1.0f; // away from the side to which the handle leans
    const glm::vec3 eyes(0, Workshop::kDrop - fixture.overTable, Workshop::kReach);
    Stance stance;
    for (int i = 0; i <= kSteps; ++i) {
        const float share = way * static_cast<float>(i) / kSteps;
        stance = {share * kTurned, share * kAside};
        const glm::vec3 sight = glm::normalize(eyes + glm::vec3(stance.aside, 0, 0));
        if (glm::dot(sight, turnOf(stance) * back) < (i == 0 ? kHidden : kClear)) break;
    }
    return stance;
}

WorkpiecePlace::WorkpiecePlace(float tableHeight, float theZoom, float bottom, const Fixture& held,
                               const Stance& stance)
    : origin(-stance.aside, tableHeight + held.overTable - bottom * theZoom, 0),
      zoom(theZoom),
      overTable(held.overTable),
      turn(turnOf(stance) * held.turn),
      stance_(turnOf(stance)) {}

glm::mat4 WorkpiecePlace::modelToWorkshop(float unit) const {
    return glm::scale(glm::translate(glm::mat4(1.0f), origin) * glm::mat4(stance_), glm::vec3(unit * zoom));
}

} // namespace meltpool
