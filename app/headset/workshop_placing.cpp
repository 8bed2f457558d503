#include "app/headset/workshop_placing.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

/// Motion within which a head lies on a desk: a worn one sways by more.
constexpr float kStill = 0.002f, kStillTurn = 0.005f; // m, rad
/// Speeds below which a head is calm.
constexpr float kCalmSpeed = 0.3f, kCalmTurn = 0.8f; // m/s, rad/s
/// Cosine of the turn away from the workpiece, seen from above, from which the person looks elsewhere: 75 degrees.
constexpr float kLooksElsewhere = 0.26f;

float turnBetween(const xr::Pose& a, const xr::Pose& b) {
    return 2 * std::acos(std::min(std::abs(glm::dot(a.orientation, b.orientation)), 1.0f));
}

} // namespace

void WorkshopPlacing::update(const PersonInFrame& person, const Workshop& workshop, double elapsed) {
    takeButton(person.buttonHeld, elapsed);
    if (person.spaceMoved) due_ = true;
    if (person.worn) {
        knowsWorn_ = true;
        putOn_ = *person.worn;
        waited_ = 0;
    }
    if (!person.head) return;
    if (!knowsWorn_) takeRest(person, elapsed);
    const glm::vec3 place = workshop.toWorkshop(*person.head).position;
    const bool farAway = glm::length(glm::vec2(place.x, place.z)) > kFarAway;
    const bool isCalm = calm(*person.head, elapsed);
    if (!putOn_ && !farAway) {
        waited_ = 0;
        return;
    }
    waited_ += elapsed;
    if (!isCalm && waited_ < kLongestWait) return;
    if (elsewhere(*person.head, workshop)) due_ = true;
    putOn_ = false;
}

void WorkshopPlacing::takeButton(bool held, double elapsed) {
    held_ = held ? std::min(held_ + elapsed, kHold) : 0;
    if (!held) acted_ = false;
    if (held_ < kHold || acted_) return;
    acted_ = true;
    due_ = true;
}

/// Notes as put on a head that rested and moves.
void WorkshopPlacing::takeRest(const PersonInFrame& person, double elapsed) {
    const xr::Pose& head = *person.head;
    const bool still = anchor_ && !person.handsAct && glm::distance(anchor_->position, head.position) < kStill &&
                       turnBetween(*anchor_, head) < kStillTurn;
    if (still) {
        rested_ += elapsed;
        return;
    }
    if (rested_ >= kRest && !person.handsAct) putOn_ = true;
    anchor_ = head;
    rested_ = 0;
}

bool WorkshopPlacing::calm(const xr::Pose& head, double elapsed) {
    const auto seconds = static_cast<float>(elapsed);
    const bool slow = last_ && glm::distance(last_->position, head.position) <= kCalmSpeed * seconds &&
                      turnBetween(*last_, head) <= kCalmTurn * seconds;
    calmFor_ = slow ? calmFor_ + elapsed : 0;
    last_ = head;
    return calmFor_ >= kCalm;
}

/// Returns true if the head is not where the workshop was placed for: elsewhere, of another height, or turned away.
bool WorkshopPlacing::elsewhere(const xr::Pose& head, const Workshop& workshop) const {
    const xr::Pose there = workshop.toWorkshop(head);
    const glm::vec2 off(there.position.x, there.position.z - Workshop::kReach);
    if (glm::length(off) > kOtherPlace || std::abs(head.position.y - placedHeight_) > kOtherHeight) return true;
    const glm::vec3 forward = there.forward();
    const glm::vec2 level(forward.x, forward.z), toWork(-there.position.x, -there.position.z);
    if (glm::length(level) < 0.1f) return false; // it looks down: at the work, or at the hands
    return glm::dot(glm::normalize(level), glm::normalize(toWork)) < kLooksElsewhere;
}

void WorkshopPlacing::placed(const xr::Pose& head) {
    due_ = putOn_ = false;
    waited_ = 0;
    placedHeight_ = head.position.y;
}

} // namespace meltpool
