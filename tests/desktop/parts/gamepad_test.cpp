// Tests the trainer's reading of a gamepad.
#include "app/desktop/gamepad.hpp"
#include "app/session/controls.hpp"
#include "app/session/gamepad_keys.hpp"
#include "tests/support/catch.hpp"

#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr std::array<unsigned char, 15> kNoButtons{};
constexpr std::array<float, 6> kRest{0, 0, 0, 0, -1, -1};

GamepadFrame withAxes(float leftX, float leftY, float rightX, float rightY, float leftTrigger, float rightTrigger) {
    return gamepadFrame(std::array{leftX, leftY, rightX, rightY, leftTrigger, rightTrigger}, kNoButtons);
}

} // namespace

TEST_CASE("sticks and triggers that hardly leave their rest are at rest, and reach their ends") {
    const GamepadFrame rest = withAxes(0.08F, -0.1F, -0.1F, 0.05F, -1, -0.95F);
    CHECK(rest.left == glm::vec2(0));
    CHECK(rest.right == glm::vec2(0));
    CHECK(rest.leftTrigger == 0);
    CHECK(rest.rightTrigger == 0);
    const GamepadFrame full = withAxes(1, 0, 0, -1, 1, 1);
    CHECK(full.left == glm::vec2(1, 0));
    CHECK(full.right == glm::vec2(0, 1)); // away from the person is up
    CHECK(full.leftTrigger == 1);
    CHECK(full.rightTrigger == 1);
    const GamepadFrame little = withAxes(0.2F, 0, 0, 0, -1, -1);
    CHECK(little.left.x > 0);
    CHECK(little.left.x < 0.1F); // slow movements are possible
    CHECK(withAxes(1, 1, 0, 0, -1, -1).left.x == Approx(std::sqrt(0.5F)));
}

TEST_CASE("shoulder buttons are read at their places") {
    std::array<unsigned char, 15> buttons{};
    buttons[4] = 1;
    CHECK(gamepadFrame(kRest, buttons).leftShoulder);
    CHECK_FALSE(gamepadFrame(kRest, buttons).rightShoulder);
    buttons = {};
    buttons[5] = 1;
    CHECK(gamepadFrame(kRest, buttons).rightShoulder);
}

TEST_CASE("a gamepad's trigger welds as far as it is pulled, and only when it has been let go after a reset") {
    Controls controls;
    controls.leadTorch(true);
    InputFrame input;
    input.gamepad.rightTrigger = 0.4F;
    controls.update(input, 0.02);
    CHECK(controls.trigger() == 0.4F);
    CHECK(controls.source().on());
    controls.reset();
    controls.update(input, 0.02);
    CHECK(controls.trigger() == 0);
    CHECK(controls.triggerLock().holdsBack());
    controls.update({}, 0.02);
    controls.update(input, 0.02);
    CHECK(controls.trigger() == 0.4F);
    input.leftHeld = true; // the mouse's button counts as fully pressed
    controls.update(input, 0.02);
    CHECK(controls.trigger() == 1);
    controls.setMode(Mode::view);
    controls.update(input, 0.02);
    CHECK(controls.trigger() == 0);
}

TEST_CASE("a gamepad is read from a text as from its axes and buttons") {
    const GamepadFrame pad = gamepadFromText("0.5 -1 0 0 -1 1 a left_shoulder right_thumb up\n");
    CHECK(pad.connected);
    CHECK(pad.left.y > 0.8F); // away from the person
    CHECK(pad.rightTrigger == 1);
    CHECK(pad.leftTrigger == 0);
    CHECK(pad.leftShoulder);
    for (size_t i = 0; i < pad.buttons.size(); ++i)
        CHECK(pad.buttons[i] == (i == size_t(GamepadButton::a) || i == size_t(GamepadButton::rightThumb) ||
                                 i == size_t(GamepadButton::up)));
    const GamepadFrame rest = gamepadFromText("no such button 7 x8");
    CHECK(rest.buttons.none());
    CHECK(rest.leftTrigger == 0);
    std::array<unsigned char, 15> all{};
    all.fill(1);
    CHECK(gamepadFrame(kRest, all).buttons.all());
}

TEST_CASE("a gamepad's buttons mean keys of the activity; the directional pad repeats in menus") {
    GamepadKeys keys;
    const auto press = [&](GamepadButton button, GamepadUse use, double seconds = 0.02) {
        InputFrame input;
        input.gamepad.connected = true;
        input.gamepad.buttons[size_t(button)] = true;
        keys.translate(input, use, seconds);
        return input;
    };
    const auto release = [&] {
        InputFrame input;
        keys.translate(input, GamepadUse::menus, 0.02);
        CHECK(input.pressed.empty());
        CHECK(input.held.none());
    };
    const InputFrame chosen = press(GamepadButton::a, GamepadUse::menus);
    CHECK(chosen.struck == std::vector{Key::enter});
    CHECK(chosen.isHeld(Key::enter));
    CHECK(keys.lastUsed());
    const InputFrame held = press(GamepadButton::a, GamepadUse::torch); // held while the page changes
    CHECK(held.struck.empty());
    release();
    CHECK(press(GamepadButton::b, GamepadUse::torch).struck == std::vector{Key::backspace});
    release();
    CHECK(press(GamepadButton::rightThumb, GamepadUse::torch).struck == std::vector{Key::g});
    release();
    CHECK(press(GamepadButton::b, GamepadUse::cut).struck == std::vector{Key::x});
    release();
    CHECK(press(GamepadButton::right, GamepadUse::menus).pressed == std::vector{Key::right});
    CHECK(press(GamepadButton::right, GamepadUse::menus).pressed.empty());
    CHECK(press(GamepadButton::right, GamepadUse::menus, GamepadKeys::kFirstRepeat).pressed == std::vector{Key::right});
    CHECK(press(GamepadButton::right, GamepadUse::menus).pressed.empty());
    CHECK(press(GamepadButton::right, GamepadUse::menus, GamepadKeys::kRepeat).struck.empty());
    release();
    InputFrame typed;
    typed.struck.push_back(Key::v);
    keys.translate(typed, GamepadUse::menus, 0.02);
    CHECK_FALSE(keys.lastUsed());
}

} // namespace meltpool
