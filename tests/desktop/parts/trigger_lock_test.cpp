// Tests that the heat stays out until the trigger, or the mouse's button, is released.
#include "app/session/controls.hpp"
#include "tests/support/catch.hpp"

namespace meltpool {

namespace {

InputFrame button(bool held, std::initializer_list<Key> struck = {}) {
    InputFrame input;
    input.leftHeld = held;
    input.struck = struck;
    return input;
}

/// Holds the button, makes `change` happen, and checks that the source is on again only after the button's release.
template <class Change>
void checkStaysOut(const Change& change) {
    Controls controls;
    controls.update(button(true), 0.02);
    REQUIRE(controls.source().on());
    change(controls);
    for (int frame = 0; frame < 5; ++frame) {
        controls.update(button(true), 0.02);
        CHECK_FALSE(controls.source().on());
        CHECK(controls.triggerLock().holdsBack());
    }
    controls.update(button(false), 0.02);
    CHECK_FALSE(controls.source().on());
    controls.update(button(true), 0.02);
    CHECK(controls.source().on());
}

} // namespace

TEST_CASE("a trigger that switches is on above 0.3 and off below 0.2") {
    TriggerSwitch wire;
    CHECK(wire.pass(0.25f) == 0.0f);
    CHECK(wire.pass(0.31f) == 1.0f);
    CHECK(wire.pass(0.25f) == 1.0f);
    CHECK(wire.pass(0.19f) == 0.0f);
    CHECK(wire.pass(0.25f) == 0.0f);
}

TEST_CASE("a lesson's beginning names itself, whatever held the trigger before") {
    TriggerLock lock;
    lock.lock(ArcOut::notFocused);
    lock.lock(ArcOut::lessonBegan);
    lock.lock(ArcOut::panel);
    CHECK(lock.reason() == ArcOut::lessonBegan);
}

TEST_CASE("a locked trigger counts when it was let go, and not while nobody knows") {
    TriggerLock lock;
    CHECK(lock.pass(0.7f) == 0.7f);
    lock.lock(ArcOut::recentred);
    lock.lock(ArcOut::torchLost);
    CHECK(lock.reason() == ArcOut::recentred);
    CHECK(lock.pass(0.7f) == 0.0f);
    CHECK(lock.holdsBack());
    CHECK(lock.pass(0.0f, false) == 0.0f); // out of sight: the value read is 0, not the finger's
    CHECK(lock.locked());
    CHECK_FALSE(lock.holdsBack());
    CHECK(lock.pass(0.06f) == 0.0f);
    CHECK(lock.pass(0.04f) == 0.04f);
    CHECK_FALSE(lock.locked());
    CHECK(lock.pass(1.0f) == 1.0f);
    for (int i = 0; i <= static_cast<int>(ArcOut::redone); ++i) {
        CHECK_FALSE(arcOutName(ArcOut(i)).empty());
        CHECK_FALSE(arcOutSentence(ArcOut(i)).empty());
    }
}

TEST_CASE("after a change of mode, of who has the mouse, a reset or a start the held button heats nothing") {
    checkStaysOut([](Controls& controls) {
        controls.update(button(true, {Key::v}), 0.02); // looks around, and works again with the button still held
        controls.update(button(true, {Key::v}), 0.02);
    });
    checkStaysOut([](Controls& controls) { controls.update(button(true, {Key::c}), 0.02); });
    checkStaysOut([](Controls& controls) { controls.reset(); });
    checkStaysOut([](Controls& controls) { controls.restart(); });
    checkStaysOut([](Controls& controls) { controls.putOut(ArcOut::takenOver); }); // a hand in a headset led the torch
}

} // namespace meltpool
