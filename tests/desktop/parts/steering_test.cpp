// Tests the keyboard's focus in the menus: gamepad and keys choose controls, move sliders and press buttons.
#include "app/desktop/steering.hpp"

#include "app/session/gamepad_keys.hpp"
#include "app/ui/focus_ring.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"

#include <string>
#include <string_view>

namespace meltpool::test {

namespace {

/// A slider, a switch and a button that are chosen by keys.
class Steered {
  public:
    Steered() {
        ImGuiIO& io = ImGui::GetIO();
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
#if IMGUI_VERSION_NUM < 18700
        for (int key = 0; key < ImGuiKey_COUNT; ++key)
            io.KeyMap[key] = key; // as a window's backend does
#endif
        frame();
        steering_.show(ImGuiDir_Left);
        frame();
        frame();
    }
    /// Holds the button for two frames and releases it.
    void press(GamepadButton button) {
        InputFrame input;
        input.gamepad.buttons[static_cast<size_t>(button)] = true;
        for (int i = 0; i < 2; ++i) {
            InputFrame held = input;
            keys_.translate(held, GamepadUse::menus, 0.02);
            frame(held);
        }
        for (int i = 0; i < 3; ++i) {
            InputFrame none;
            keys_.translate(none, GamepadUse::menus, 0.02);
            frame(none);
        }
    }
    /// Presses and releases a key between two frames.
    void tap(Key key) {
        InputFrame input;
        input.held[static_cast<size_t>(key)] = true;
        input.pressed = input.struck = {key};
#if IMGUI_VERSION_NUM >= 18700 // the window's backend tells of both
        const ImGuiKey its = key == Key::down        ? ImGuiKey_DownArrow
                             : key == Key::backspace ? ImGuiKey_Backspace
                                                     : ImGuiKey_Enter;
        ImGui::GetIO().AddKeyEvent(its, true);
        ImGui::GetIO().AddKeyEvent(its, false);
#endif
        frame(input);
        for (int i = 0; i < 3; ++i)
            frame();
    }
    void frame(const InputFrame& input = {}) {
        steering_.press(steers, input);
        interface_.draw([this](ui::Context& context) { content(context); });
    }
    /// Clicks the slider's value and types a text in its field.
    void typeByMouse(std::string_view text) {
        const auto drawn = [this](ui::Context& context) { content(context); };
        interface_.click("test.slider.value", drawn);
        frame();
        interface_.type(text, drawn);
    }

    bool steers = true;
    float value = 5;
    bool on = false;
    int presses = 0;
    std::string focus;

  private:
    void content(ui::Context& context) {
        ui::parameterControl(context, "test", slider_, defaults_);
        ui::toggle(context, "test.switch", "Switch", on);
        presses += ui::button(context, "test.button", "Button") ? 1 : 0;
        focus = context.focus;
    }

    DrawnInterface interface_;
    ui::Steering steering_;
    GamepadKeys keys_;
    Parameter slider_{"slider", "Slider", "mm", &value, 0, 10, ""};
    DefaultTexts defaults_{{"slider", "5"}};
};

} // namespace

TEST_CASE("arrows choose controls and move the chosen slider; A presses the chosen button") {
    Steered menus;
    CHECK(menus.focus == "test.slider");
    menus.press(GamepadButton::right);
    CHECK(menus.value == Approx(5.2));
    CHECK(menus.focus == "test.slider");
    menus.press(GamepadButton::left);
    menus.press(GamepadButton::left);
    CHECK(menus.value == Approx(4.8));
    menus.press(GamepadButton::down);
    CHECK(menus.focus == "test.switch");
    CHECK(menus.value == Approx(4.8));
    menus.press(GamepadButton::a);
    CHECK(menus.on);
    menus.press(GamepadButton::a);
    CHECK_FALSE(menus.on);
    menus.press(GamepadButton::down);
    CHECK(menus.focus == "test.button");
    menus.press(GamepadButton::a);
    CHECK(menus.presses == 1);
    menus.press(GamepadButton::up);
    CHECK(menus.focus == "test.switch");
}

TEST_CASE("a tap between two frames counts, however slow they are") {
    Steered menus;
    menus.press(GamepadButton::right);
    menus.tap(Key::backspace); // the slider's first value
    CHECK(menus.value == Approx(5));
    menus.tap(Key::down);
    CHECK(menus.focus == "test.switch");
    menus.tap(Key::enter);
    CHECK(menus.on);
}

TEST_CASE("a tap counts in a field that a click has opened, while keys lead the torch") {
    Steered menus;
    menus.steers = false;
    menus.typeByMouse("7.5");
    menus.tap(Key::backspace);
    menus.tap(Key::enter);
    CHECK(menus.value == Approx(7));
}

TEST_CASE("the torch's buttons press no control") {
    Steered menus;
    menus.press(GamepadButton::down);
    menus.press(GamepadButton::down);
    CHECK(menus.focus == "test.button");
    menus.steers = false;
    menus.press(GamepadButton::a);
    CHECK(menus.presses == 0);
}

TEST_CASE("the focus goes through the drawn windows and round") {
    ui::FocusRing ring;
    CHECK(ring.following() == nullptr);
    const auto draw = [&](int focused) {
        int i = 0;
        for (const char* window : {"bar", "view", "machine"})
            ring.note(window, i++ == focused);
        ring.beginFrame();
        return std::string_view(ring.following());
    };
    CHECK(draw(0) == "view");
    CHECK(draw(1) == "machine");
    CHECK(draw(2) == "bar");
    ring.note("bar", false);
    ring.beginFrame();
    CHECK(std::string_view(ring.following()) == "bar");
}

} // namespace meltpool::test
