#include "app/session/controls.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kOrbitSpeed = 1.4f;    ///< rad/s
constexpr float kApproachSpeed = 1.0f; ///< nearer or farther by a factor of e per second
constexpr float kFlySpeed = 1.5f;      ///< box units per second
constexpr float kLookSpeed = 0.0035f;  ///< rad per point of mouse travel
constexpr float kNotch = 0.12f;        ///< logarithm of the factor per wheel notch
constexpr double kLongestFrame = 0.1;  ///< s; a longer frame moves the camera no farther

/// Direction of a pair of keys: 1, -1 or 0.
float axis(const InputFrame& input, Key positive, Key negative) {
    return static_cast<float>(input.isHeld(positive)) - static_cast<float>(input.isHeld(negative));
}

} // namespace

/// True if mouse button or space bar weld.
bool Controls::weldsByDesk(const InputFrame& input) const {
    return input.leftHeld || (parameters.spaceLatch ? latched_ : input.isHeld(Key::space));
}

/// Travel of the mouse button, the space bar or the gamepad's trigger, 0..1.
float Controls::pulled(const InputFrame& input) const {
    return weldsByDesk(input) ? 1.0f : input.gamepad.rightTrigger;
}

void Controls::pull(float trigger) {
    trigger_ = trigger;
    source_.setOn(trigger > 0);
}

void Controls::update(const InputFrame& frame, double seconds) {
    InputFrame input = frame;
    if (!captured_) input.mouseMove = frame.dragMove;
    for (const Key key : input.struck) {
        if (key == Key::v) setMode(mode_ == Mode::interact ? Mode::view : Mode::interact);
        if (key == Key::c) capture(!captured_);
        if (key == Key::escape) capture(false);
        if (key == Key::f) source_.setCold(!source_.cold());
        if (key == Key::space) latched_ = parameters.spaceLatch && mode_ == Mode::interact && !latched_;
    }
    if (input.lostFocus) latched_ = false;
    const float time = static_cast<float>(std::clamp(seconds, 0.0, kLongestFrame));
    if (mode_ == Mode::interact)
        work(input, time);
    else
        look(input, time);
}

void Controls::work(const InputFrame& input, float seconds) {
    const float turn = kOrbitSpeed * parameters.cameraSpeed * seconds;
    orbit_.orbit({axis(input, Key::d, Key::a) * turn, axis(input, Key::w, Key::s) * turn});
    const float away = axis(input, Key::e, Key::q) * kApproachSpeed * parameters.cameraSpeed * seconds;
    const bool wheelForTorch = leadsTorch_ && (captured_ || weldsByDesk(input));
    orbit_.approach(std::exp(away - (wheelForTorch ? 0 : input.scroll) * kNotch));

    hand_ = input;
    if (!wheelForTorch) hand_.scroll = 0;
    if (!leadsTorch_) {
        source_.move(input, orbit_.forward(), parameters);
        source_.lead(input.gamepad, orbit_.forward(), parameters, seconds);
    }
    pull(lock_.pass(pulled(input)));
}

void Controls::look(const InputFrame& input, float seconds) {
    hand_ = {};
    lock_.pass(pulled(input));
    pull(0);
    const float turn = kLookSpeed * parameters.lookSpeed;
    const float upwards = parameters.invertLook ? 1.0f : -1.0f;
    free_.look({input.mouseMove.x * turn, input.mouseMove.y * turn * upwards});
    const float way = kFlySpeed * parameters.cameraSpeed * seconds;
    free_.move(way * glm::vec3(axis(input, Key::d, Key::a), axis(input, Key::e, Key::q), axis(input, Key::w, Key::s)));
    free_.move({0, 0, input.scroll * kNotch});
}

void Controls::setMode(Mode mode) {
    if (mode == mode_) return;
    // The free camera starts where the orbiting one is, so that the picture does not jump.
    if (mode == Mode::view) free_ = FreeCamera(orbit_.position(), orbit_.target());
    mode_ = mode;
    putOut(ArcOut::paused);
}

void Controls::capture(bool captured) {
    lent_ = false;
    if (captured == captured_) return;
    captured_ = captured;
    putOut(ArcOut::takenOver);
}

void Controls::lendMouse() {
    if (!captured_) return;
    capture(false);
    lent_ = true;
}

void Controls::takeBackMouse() {
    if (lent_) capture(true);
}

void Controls::restart() {
    mode_ = Mode::interact;
    captured_ = lent_ = false;
    free_ = FreeCamera();
    orbit_ = OrbitCamera();
    source_ = SteeredSource();
    putOut(ArcOut::lessonBegan);
}

View Controls::view(float aspect) const {
    return mode_ == Mode::interact ? orbit_.view(lens, aspect) : free_.view(lens, aspect);
}

glm::vec3 Controls::eye() const {
    return mode_ == Mode::interact ? orbit_.position() : free_.position();
}

glm::vec3 Controls::forward() const {
    return mode_ == Mode::interact ? orbit_.forward() : free_.forward();
}

} // namespace meltpool
