#include "app/headset/panel_pointer.hpp"

namespace meltpool {

void PanelPointer::update(const xr::Input& input, const Workshop& workshop, const xr::PanelShape& shape,
                          xr::Hand torchHand) {
    torchHand_ = torchHand;
    for (const xr::Hand hand : {xr::Hand::left, xr::Hand::right}) {
        if (!input.hand(hand).menu) continue;
        open_ = !open_;
        hand_ = hand;
    }
    pointer_ = {};
    if (!open_) return;
    const xr::Hand other = hand_ == xr::Hand::left ? xr::Hand::right : xr::Hand::left;
    if (pointWith(other, input, workshop, shape) && pointer_.pressed)
        hand_ = other;
    else
        pointWith(hand_, input, workshop, shape);
}

xr::Pose PanelPointer::pose() const {
    // Places the panel next to and behind the workpiece, away from the torch's hand, turned to the person's place.
    const float side = torchHand_ == xr::Hand::right ? -1.0f : 1.0f;
    return {glm::angleAxis(-side * 0.48f, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.2f, glm::vec3(1, 0, 0)),
            {side * 0.42f, parameters_.tableHeight + 0.45f, -0.35f}};
}

std::optional<xr::Hand> PanelPointer::pointingHand() const {
    return pointer_.place ? std::optional(hand_) : std::nullopt;
}

bool PanelPointer::pointWith(xr::Hand which, const xr::Input& input, const Workshop& workshop,
                             const xr::PanelShape& shape) {
    pointer_ = {};
    const xr::HandInput& hand = input.hand(which);
    if (!hand.tracked) return false;
    const xr::Pose panel = pose();
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
