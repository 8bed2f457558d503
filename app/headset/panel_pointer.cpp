#include "app/headset/panel_pointer.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kMoving = 0.3;       // s from one place to the other
constexpr float kUnderEyes = 0.12f;   // m, the panel's middle in front
constexpr float kOverTable = 0.40f;   // m, least height of the panel's middle
constexpr float kOtherHeight = 0.15f; // m, by which other eyes are higher or lower
constexpr float kAsideX = 0.42f;      // m

} // namespace

void PanelPointer::update(Hands hands, const Workshop& workshop, const xr::PanelShape& shape, xr::Hand torchHand,
                          bool torchWorks) {
    if (!open_) hand_ = torchHand; // the trigger in the hand that works presses first
    for (const xr::Hand hand : {xr::Hand::left, xr::Hand::right}) {
        if (!hands[size_t(hand)].menu) continue;
        open_ = !open_;
        called_ = hand == torchHand;
        hand_ = hand;
    }
    pointer_ = {};
    if (!open_) return;
    const auto points = [&](xr::Hand hand) {
        pointer_ = {};
        return !(torchWorks && !called_ && hand == torchHand) && pointWith(hand, hands, workshop, shape);
    };
    const xr::Hand other = hand_ == xr::Hand::left ? xr::Hand::right : xr::Hand::left;
    if (points(other) && pointer_.pressed)
        hand_ = other;
    else
        points(hand_);
}

void PanelPointer::move(bool aside, const std::optional<glm::vec3>& eyes, xr::Hand torchHand, double elapsed) {
    const float table = parameters_.tableHeight;
    if (!heightKnown_) height_ = table + kOverTable;
    if (eyes && !pointer_.pressed) {
        const float wanted = std::max(eyes->y - kUnderEyes, table + kOverTable);
        // A nod or a lean over the work leaves it in its place.
        if (!heightKnown_ || !open_ || aside_ >= 1 || std::abs(wanted - height_) > kOtherHeight) {
            height_ = wanted;
            tilt_ = std::atan2(eyes->y - height_, Workshop::kReach + kBehind);
            heightKnown_ = true;
        }
    }
    const auto steps = static_cast<float>(elapsed / kMoving);
    const auto approach = [](float& value, float target, float step) {
        value += std::clamp(target - value, -step, step);
    };
    const float side = torchHand == xr::Hand::right ? -1.0f : 1.0f;
    if (!open_) {
        aside_ = aside ? 1.0f : 0.0f;
        side_ = side;
    } else if (!pointer_.pressed) {
        approach(aside_, aside && side_ == side ? 1.0f : 0.0f, steps);
        if (aside_ == 0) side_ = side;
    }
    const float share = aside_ * aside_ * (3 - 2 * aside_);
    const glm::vec3 there(side_ * kAsideX, table + kOverTable + 0.05f, -kBehind);
    pose_.position = glm::mix(glm::vec3(0, height_, -kBehind), there, share);
    pose_.orientation = glm::angleAxis(-share * side_ * 0.48f, glm::vec3(0, 1, 0)) *
                        glm::angleAxis(-glm::mix(tilt_, 0.2f, share), glm::vec3(1, 0, 0));
}

std::optional<xr::Hand> PanelPointer::pointingHand() const {
    return pointer_.place ? std::optional(hand_) : std::nullopt;
}

bool PanelPointer::pointWith(xr::Hand which, Hands hands, const Workshop& workshop, const xr::PanelShape& shape) {
    const xr::HandInput& hand = hands[size_t(which)];
    if (!hand.tracked) return false;
    const xr::Pose& panel = pose_;
    ray_ = workshop.toWorkshop(hand.aim);
    const std::optional<glm::vec2> place = xr::pointOnPanel(ray_, panel, shape);
    if (!place) return false;
    pointer_ = {place, hand.trigger > 0.5f, hand.scrollY * 0.3f};
    const float metres = shape.width / static_cast<float>(shape.widthPixels);
    const glm::vec2 middle(float(shape.widthPixels) / 2, float(shape.heightPixels) / 2);
    const glm::vec2 local = (*place - middle) * metres;
    rayEnd_ = panel * glm::vec3(local.x, -local.y, 0.002f);
    return true;
}

} // namespace meltpool
