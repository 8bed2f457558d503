// Tests the trainer's reading of a gamepad.
#include "app/desktop/gamepad.hpp"
#include "app/session/controls.hpp"
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

} // namespace meltpool
