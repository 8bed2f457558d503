#include "app/session/heat_source.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace meltpool {

namespace {

constexpr glm::vec3 kUp{0, 1, 0};
constexpr float kStickSpeed = 0.6f;   ///< box units a second with a stick pushed all the way at speed 1
constexpr float kPointsPerUnit = 500; ///< mouse travel for one box unit at speed 1

/// Horizontal unit vector away from the person. A view straight down or up has none: then it is -z.
glm::vec3 awayFrom(glm::vec3 view) {
    const glm::vec3 flat{view.x, 0, view.z};
    const float length = glm::length(flat);
    return length < 1e-4f ? glm::vec3{0, 0, -1} : flat / length;
}

} // namespace

ParameterList describe(ControlParameters& p) {
    return {
        {"source_step", "Step of the arrow keys", "box units", &p.sourceStep, 0.005, 0.5,
         "Path of the torch for one press of an arrow or page key. One box unit is 40 mm."},
        {"source_mouse_speed", "Mouse speed of the torch", "", &p.sourceMouseSpeed, 0.1, 5,
         "A higher speed needs less hand movement, but the torch is harder to hold still."},
        {"torch_mouse_mm", "Mouse travel of a welding torch", "mm", &p.torchMouse, 0.5, 50,
         "Path of the torch for 100 points of the mouse. Less is steadier."},
        {"guide_speed_mm_s", "Guide speed", "mm/s", &p.guideSpeed, 0, 30,
         "Moves a welding torch along the seam while it welds. At 0 the mouse leads it."},
        {"hand_tremor", "Hand tremor", "", &p.tremor, 0, 4,
         "Makes a welding torch tremble like a hand. 1 is 0.3 mm and 2 degrees at 8 Hz; 0 is still."},
        {"key_speed_mm_s", "Speed of the keys", "mm/s", &p.keySpeed, 0, 30,
         "Speed of a welding torch while you hold Shift and an arrow key. At 0 it is the speed that the lesson asks "
         "for."},
        {"space_latch", "Space starts and stops the weld", "", &p.spaceLatch, 0, 1,
         "Press the space bar once to weld and once more to stop, instead of holding it."},
        {"gamepad_speed_mm_s", "Speed of a gamepad's stick", "mm/s", &p.gamepadSpeed, 1, 60,
         "Speed of a welding torch with the left stick pushed all the way."},
        {"look_speed", "Mouse speed when looking", "", &p.lookSpeed, 0.1, 5, "Turning speed of the free camera."},
        {"camera_speed", "Speed of the camera keys", "", &p.cameraSpeed, 0.1, 5, "Camera speed with A D W S Q E."},
        {"invert_look", "Invert looking up and down", "", &p.invertLook, 0, 1,
         "Pull the mouse towards you to look up, as in an aeroplane."},
    };
}

void SteeredSource::move(const InputFrame& input, glm::vec3 view, const ControlParameters& parameters) {
    const glm::vec3 away = awayFrom(view);
    const glm::vec3 side = glm::cross(away, kUp);
    glm::vec3 shift{0};
    for (const Key key : input.pressed) {
        switch (key) {
        case Key::up:
            shift += away * parameters.sourceStep;
            break;
        case Key::down:
            shift -= away * parameters.sourceStep;
            break;
        case Key::right:
            shift += side * parameters.sourceStep;
            break;
        case Key::left:
            shift -= side * parameters.sourceStep;
            break;
        case Key::pageUp:
            shift += kUp * parameters.sourceStep;
            break;
        case Key::pageDown:
            shift -= kUp * parameters.sourceStep;
            break;
        default:
            break;
        }
    }
    const glm::vec2 hand = input.mouseMove * (parameters.sourceMouseSpeed / kPointsPerUnit);
    shift += side * hand.x - (input.rightHeld ? away : kUp) * hand.y;
    setPosition(position_ + shift);
}

void SteeredSource::lead(const GamepadFrame& gamepad, glm::vec3 view, const ControlParameters& parameters,
                         float seconds) {
    const glm::vec3 away = awayFrom(view);
    const glm::vec3 way = glm::cross(away, kUp) * gamepad.left.x + kUp * gamepad.left.y + away * gamepad.right.y;
    setPosition(position_ + way * (kStickSpeed * parameters.sourceMouseSpeed * seconds));
}

void SteeredSource::setPosition(glm::vec3 position) {
    position_ = glm::clamp(position, glm::vec3(-1), glm::vec3(1));
}

void SteeredSource::reset() {
    position_ = kHome;
    on_ = false;
}

} // namespace meltpool
