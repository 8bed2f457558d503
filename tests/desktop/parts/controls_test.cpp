// Tests the effect of keys and mouse on modes, cameras and heat source, without a window.
#include "app/session/controls.hpp"
#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>

#include <random>

namespace meltpool {

namespace {

InputFrame struck(Key key) {
    InputFrame input;
    input.held[static_cast<size_t>(key)] = true;
    input.pressed.push_back(key);
    input.struck.push_back(key);
    return input;
}

InputFrame held(Key key) {
    InputFrame input;
    input.held[static_cast<size_t>(key)] = true;
    return input;
}

bool near(glm::vec3 a, glm::vec3 b) {
    return glm::length(a - b) < 1e-5f;
}

} // namespace

TEST_CASE("keys step the source along the view's horizontal part, to its side, up and down") {
    const glm::vec3 view = glm::normalize(glm::vec3(-1, -0.7f, -1));
    const glm::vec3 away = glm::normalize(glm::vec3(-1, 0, -1));
    const glm::vec3 right = glm::normalize(glm::vec3(1, 0, -1));
    const ControlParameters parameters;
    const float step = parameters.sourceStep;
    const auto moved = [&](Key key) {
        SteeredSource source;
        source.setPosition(glm::vec3(0));
        source.move(struck(key), view, parameters);
        return source.position();
    };
    CHECK(near(moved(Key::up), away * step));
    CHECK(near(moved(Key::down), -away * step));
    CHECK(near(moved(Key::right), right * step));
    CHECK(near(moved(Key::left), -right * step));
    CHECK(near(moved(Key::pageUp), {0, step, 0}));
    CHECK(near(moved(Key::pageDown), {0, -step, 0}));
    CHECK(near(moved(Key::a), {0, 0, 0}));
}

TEST_CASE("a key that repeats steps again each time") {
    SteeredSource source;
    source.setPosition(glm::vec3(0));
    InputFrame input = struck(Key::pageUp);
    input.pressed.push_back(Key::pageUp);
    input.pressed.push_back(Key::pageUp);
    source.move(input, {0, 0, -1}, {});
    CHECK(near(source.position(), {0, 0.15f, 0}));
}

TEST_CASE("looking straight down leaves a way that is away") {
    SteeredSource source;
    source.setPosition(glm::vec3(0));
    source.move(struck(Key::up), {0, -1, 0}, {});
    CHECK(near(source.position(), {0, 0, -0.05f}));
}

TEST_CASE("the mouse moves the source sideways and up, with the right button forward and back") {
    ControlParameters parameters;
    parameters.sourceMouseSpeed = 2;
    InputFrame input;
    input.mouseMove = {50, 100}; // movement to the right and towards the person
    SteeredSource source;
    source.setPosition(glm::vec3(0));
    source.move(input, {0, 0, -1}, parameters);
    CHECK(near(source.position(), {0.2f, -0.4f, 0}));
    input.rightHeld = true;
    source.setPosition(glm::vec3(0));
    source.move(input, {0, 0, -1}, parameters);
    CHECK(near(source.position(), {0.2f, 0, 0.4f}));
}

TEST_CASE("the source never leaves the box, whatever the hand does") {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> travel(-4000, 4000);
    Controls controls;
    controls.captureMouse();
    for (int i = 0; i < 500; ++i) {
        InputFrame input = struck(static_cast<Key>(i % static_cast<int>(Key::c)));
        input.mouseMove = {travel(random), travel(random)};
        input.rightHeld = i % 3 == 0;
        controls.update(input, 0.02);
        const glm::vec3 p = controls.source().position();
        for (int axis = 0; axis < 3; ++axis) {
            REQUIRE(p[axis] >= -1);
            REQUIRE(p[axis] <= 1);
        }
    }
}

TEST_CASE("the source is on only while the left button is held and the person works") {
    Controls controls;
    CHECK(near(controls.source().position(), {0.9f, 0.9f, 0.9f}));
    InputFrame pressed;
    pressed.leftHeld = true;
    controls.update(pressed, 0.02);
    CHECK(controls.source().on());
    controls.update({}, 0.02);
    CHECK_FALSE(controls.source().on());
    controls.update(struck(Key::v), 0.02);
    controls.update(pressed, 0.02);
    CHECK_FALSE(controls.source().on());
}

TEST_CASE("with a torch the wheel is its own while button or space bar weld, else the camera's") {
    for (const bool space : {false, true}) {
        Controls controls;
        controls.leadTorch(true);
        const float before = glm::length(controls.eye());
        InputFrame input = space ? held(Key::space) : InputFrame();
        input.leftHeld = !space;
        input.scroll = 1;
        controls.update(input, 0.02);
        CHECK(controls.hand().scroll == 1);
        CHECK(glm::length(controls.eye()) == Approx(before));
        InputFrame free;
        free.scroll = 1;
        controls.update(free, 0.02);
        CHECK(controls.hand().scroll == 0);
        CHECK(glm::length(controls.eye()) < before);
    }
}

TEST_CASE("a free mouse moves the source only with a button down, a captured one always") {
    Controls controls;
    InputFrame input;
    input.mouseMove = {-100, 0};
    controls.update(input, 0.02);
    CHECK(near(controls.source().position(), SteeredSource::kHome));
    input.dragMove = {-40, 0};
    input.leftHeld = true;
    controls.update(input, 0.02);
    const float dragged = glm::length(controls.source().position() - SteeredSource::kHome);
    CHECK(dragged == Approx(0.08f).epsilon(1e-3));
    controls.source().setPosition(glm::vec3(0));
    controls.update(struck(Key::c), 0.02);
    REQUIRE(controls.captured());
    input.leftHeld = false;
    controls.update(input, 0.02);
    CHECK(glm::length(controls.source().position()) == Approx(0.2f).epsilon(1e-3));
}

TEST_CASE("V changes the mode, the picture does not jump, C and Escape give the mouse back") {
    Controls controls;
    const glm::vec3 eye = controls.eye();
    const glm::vec3 forward = controls.forward();
    controls.update(struck(Key::v), 0.02);
    CHECK(controls.mode() == Mode::view);
    CHECK(glm::length(controls.eye() - eye) < 1e-3f);
    CHECK(glm::dot(controls.forward(), forward) > 0.9999f);
    controls.update(struck(Key::v), 0.02);
    CHECK(controls.mode() == Mode::interact);
    controls.update(struck(Key::c), 0.02);
    CHECK(controls.captured());
    controls.update(struck(Key::c), 0.02);
    CHECK_FALSE(controls.captured());
    controls.update(struck(Key::c), 0.02);
    controls.update(struck(Key::escape), 0.02);
    CHECK_FALSE(controls.captured());
}

TEST_CASE("working, the camera goes around, over, nearer and farther, and looks at the origin") {
    Controls controls;
    const float azimuth = controls.orbitCamera().azimuth();
    const float elevation = controls.orbitCamera().elevation();
    const float distance = controls.orbitCamera().distance();
    controls.update(held(Key::d), 0.05);
    CHECK(controls.orbitCamera().azimuth() > azimuth);
    controls.update(held(Key::a), 0.1);
    CHECK(controls.orbitCamera().azimuth() < azimuth);
    controls.update(held(Key::w), 0.05);
    CHECK(controls.orbitCamera().elevation() > elevation);
    controls.update(held(Key::s), 0.1);
    CHECK(controls.orbitCamera().elevation() < elevation);
    controls.update(held(Key::e), 0.05);
    CHECK(controls.orbitCamera().distance() > distance);
    controls.update(held(Key::q), 0.1);
    CHECK(controls.orbitCamera().distance() < distance);
    CHECK(glm::dot(controls.forward(), -glm::normalize(controls.eye())) > 0.9999f);
}

TEST_CASE("looking around, the mouse looks and the keys fly, pitch stays inside the poles") {
    Controls controls;
    controls.update(struck(Key::v), 0.02);
    controls.captureMouse();
    const glm::vec3 eye = controls.eye();
    const glm::vec3 forward = controls.forward();
    controls.update(held(Key::w), 0.1);
    CHECK(glm::dot(controls.eye() - eye, forward) > 0.05f);
    const float yaw = controls.freeCamera().yaw();
    InputFrame input;
    input.mouseMove = {100, 0};
    controls.update(input, 0.02);
    CHECK(controls.freeCamera().yaw() < yaw);
    input.mouseMove = {0, -100000};
    controls.update(input, 0.02);
    CHECK(controls.freeCamera().pitch() > 1.5f);
    CHECK(controls.freeCamera().pitch() < 1.5708f);
    controls.parameters.invertLook = true;
    controls.update(input, 0.02);
    CHECK(controls.freeCamera().pitch() < -1.5f);
}

TEST_CASE("F turns the source cold and hot; reset keeps that and takes the source home") {
    Controls controls;
    controls.update(struck(Key::f), 0.02);
    controls.update(struck(Key::pageDown), 0.02);
    CHECK(controls.source().cold());
    CHECK(controls.source().position().y == Approx(0.85f));
    controls.reset();
    CHECK(controls.source().cold());
    CHECK(near(controls.source().position(), SteeredSource::kHome));
    controls.update(struck(Key::f), 0.02);
    CHECK_FALSE(controls.source().cold());
}

TEST_CASE("a frame that hung for seconds does not throw the camera away") {
    Controls slow;
    Controls quick;
    slow.update(held(Key::d), 30);
    quick.update(held(Key::d), 0.1);
    CHECK(slow.orbitCamera().azimuth() == quick.orbitCamera().azimuth());
}

TEST_CASE("with its setting the space bar starts and stops the weld; whatever locks the trigger stops it") {
    Controls controls;
    controls.leadTorch(true);
    controls.update(struck(Key::space), 0.02);
    CHECK(controls.trigger() == 1);
    controls.update({}, 0.02);
    CHECK(controls.trigger() == 0); // held, as it is at first
    controls.parameters.spaceLatch = true;
    const auto weld = [&] {
        controls.update(struck(Key::space), 0.02);
        controls.update({}, 0.02);
        return controls.trigger() == 1;
    };
    CHECK(weld());
    CHECK_FALSE(weld());
    CHECK(weld());
    InputFrame elsewhere;
    elsewhere.lostFocus = true;
    controls.update(elsewhere, 0.02);
    CHECK(controls.trigger() == 0);
    CHECK(weld());
    controls.reset();
    controls.update({}, 0.02);
    CHECK(controls.trigger() == 0);
    CHECK(weld());
    controls.setMode(Mode::view);
    controls.update({}, 0.02);
    CHECK(controls.trigger() == 0);
    controls.setMode(Mode::interact);
    controls.update({}, 0.02);
    CHECK(controls.trigger() == 0);
}

TEST_CASE("a gamepad's sticks move the source sideways, up and away from the person") {
    const ControlParameters parameters;
    const glm::vec3 view(0, 0, -1);
    const auto moved = [&](glm::vec2 left, glm::vec2 right) {
        SteeredSource source;
        source.setPosition(glm::vec3(0));
        GamepadFrame gamepad;
        gamepad.left = left;
        gamepad.right = right;
        source.lead(gamepad, view, parameters, 0.1f);
        return source.position();
    };
    CHECK(moved({1, 0}, {0, 0}).x > 0.01f);
    CHECK(moved({0, 1}, {0, 0}).y > 0.01f);
    CHECK(moved({0, 0}, {0, 1}).z < -0.01f);
    CHECK(near(moved({0, 0}, {1, 0}), glm::vec3(0)));
}

TEST_CASE("a locked mouse that was lent is locked again; one that the person freed or locked since is not") {
    Controls controls;
    controls.takeBackMouse();
    CHECK_FALSE(controls.captured());
    controls.update(struck(Key::c), 0.02);
    REQUIRE(controls.captured());
    controls.lendMouse();
    CHECK_FALSE(controls.captured());
    controls.takeBackMouse();
    CHECK(controls.captured());
    controls.lendMouse();
    controls.releaseMouse();
    controls.takeBackMouse();
    CHECK_FALSE(controls.captured());
}

} // namespace meltpool
