// The heat source that keys and mouse move: its position and its switch.
#pragma once

#include "app/session/input.hpp"
#include "core/base/parameter.hpp"

#include <glm/vec3.hpp>

namespace meltpool {

/// Speeds of keys and mouse. Lengths in box units (one is 40 mm).
struct ControlParameters {
    float sourceStep = 0.05f;      ///< step per arrow or page key
    float sourceMouseSpeed = 1.0f; ///< box units for 500 points of mouse travel
    float lookSpeed = 1.0f;        ///< factor on the mouse in view mode
    float cameraSpeed = 1.0f;      ///< factor on the camera keys
    bool invertLook = false;       ///< true: pulling the mouse looks up
    float torchMouse = 8;          ///< mm of a welding torch for 100 points of mouse travel
    float guideSpeed = 0;          ///< mm/s at which a welding torch travels along the seam by itself while it welds
    float tremor = 0;              ///< tremor of the hand with a welding torch, as a multiple of a practised one's
    float keySpeed = 0;            ///< mm/s of a welding torch with Shift and an arrow key held; 0: the lesson's
    bool spaceLatch = false;       ///< true: the space bar starts and stops the weld; false: it welds while held
    float gamepadSpeed = 15;       ///< mm/s of a welding torch with a gamepad's stick pushed all the way
};
ParameterList describe(ControlParameters& parameters);

/// Position in box units, always inside [-1, 1]³.
class SteeredSource {
  public:
    static constexpr glm::vec3 kHome{0.9f, 0.9f, 0.9f};

    /// Moves the source. `view`: unit vector of the camera's direction. Arrow keys step along its horizontal part and
    /// to its side, page keys up and down; mouse travel moves it sideways and up, with the right button held forward
    /// instead of up.
    void move(const InputFrame& input, glm::vec3 view, const ControlParameters& parameters);

    /// Moves the source for `seconds`: a gamepad's left stick sideways and up, its right stick farther and nearer.
    void lead(const GamepadFrame& gamepad, glm::vec3 view, const ControlParameters& parameters, float seconds);

    void reset();
    void setOn(bool on) { on_ = on; }
    void setCold(bool cold) { cold_ = cold; }
    void setPosition(glm::vec3 position);

    glm::vec3 position() const { return position_; }
    bool on() const { return on_; }
    bool cold() const { return cold_; }

  private:
    glm::vec3 position_ = kHome;
    bool on_ = false;
    bool cold_ = false;
};

} // namespace meltpool
