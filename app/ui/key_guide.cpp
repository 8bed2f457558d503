#include "app/ui/key_guide.hpp"

#include "core/base/words.hpp"

#include <utility>

namespace meltpool::ui {

namespace {

KeyRow keys(KeyHeading heading, std::initializer_list<Key> used, std::string_view what, std::string_view hint = {},
            std::string_view name = {}) {
    KeyRow row{.heading = heading, .name = name, .what = what, .hint = hint, .pad = {}};
    for (const Key key : used)
        row.keys[row.count++] = key;
    return row;
}

/// Returns a row of the mouse or the wheel.
KeyRow mouse(KeyHeading heading, std::string_view name, std::string_view what, std::string_view hint = {}) {
    return keys(heading, {}, what, hint, name);
}

/// Returns the name of a key that is no letter; empty for arrow, page and shift keys, whose rows have a phrase.
std::string_view nameOf(Key key) {
    static constexpr std::array<std::pair<Key, std::string_view>, 10> kFunctionKeys{{{Key::f1, "F1"},
                                                                                     {Key::f2, "F2"},
                                                                                     {Key::f3, "F3"},
                                                                                     {Key::f4, "F4"},
                                                                                     {Key::f5, "F5"},
                                                                                     {Key::f6, "F6"},
                                                                                     {Key::f9, "F9"},
                                                                                     {Key::f10, "F10"},
                                                                                     {Key::f11, "F11"},
                                                                                     {Key::f12, "F12"}}};
    static constexpr std::array<std::pair<Key, std::string_view>, 5> kNamedKeys{{{Key::escape, "help.key.escape"},
                                                                                 {Key::enter, "help.key.enter"},
                                                                                 {Key::backspace, "help.key.backspace"},
                                                                                 {Key::space, "help.key.space"},
                                                                                 {Key::tab, "help.key.tab"}}};
    for (const auto& [which, name] : kFunctionKeys)
        if (which == key) return name;
    for (const auto& [which, name] : kNamedKeys)
        if (which == key) return phrase(name);
    return {};
}

/// Phrase of a gamepad's button.
std::string_view padName(GamepadButton button) {
    static constexpr std::array<std::string_view, size_t(GamepadButton::count)> kNames{
        "help.pad.a",          "help.pad.b",       "help.pad.x",           "help.pad.y",
        "help.pad.view",       "help.pad.menu",    "help.pad.right_thumb", "help.pad.up_down",
        "help.pad.left_right", "help.pad.up_down", "help.pad.left_right"};
    return kNames[size_t(button)];
}

/// Phrase of the button that means one of the row's keys; empty if none does.
std::string_view padOf(const KeyRow& row, GamepadUse use) {
    for (const Key key : row.used())
        for (size_t i = 0; i < size_t(GamepadButton::count); ++i)
            if (keyOf(static_cast<GamepadButton>(i), use) == key) return padName(static_cast<GamepadButton>(i));
    return {};
}

GamepadUse useIn(const KeySituation& now) {
    if (!now.lesson || now.menus) return GamepadUse::menus;
    if (now.cut) return GamepadUse::cut;
    return now.demonstration || now.replay ? GamepadUse::playing : GamepadUse::torch;
}

} // namespace

KeySituation keySituation(const Controls& controls, LessonSession& session, bool home, bool headset) {
    KeySituation now;
    now.headset = headset;
    now.home = home;
    now.lesson = !home && session.running();
    if (!now.lesson) return now;
    const Activities& activities = session.activities();
    const bool own = activities.allowed().ownTorch;
    const bool weld = session.lesson().model == LessonModel::Weld;
    now.looking = controls.mode() == Mode::view;
    now.caught = controls.captured();
    now.demonstration = activities.at(activities.demonstration);
    now.replay = activities.at(activities.replay);
    now.cut = session.picture().cut().shown();
    now.seam = own && session.deskTorch().leads();
    now.source = own && !now.seam;
    now.cold = now.source && !weld;
    now.arc = weld && isArcWelding(session.lesson().process);
    now.rod = now.seam && session.deskTorch().hasRod();
    now.weaves = now.seam && session.deskTorch().weave().weave();
    now.swings = now.weaves && session.deskTorch().weave().on();
    now.judges = session.judges();
    now.next = now.judges && session.attempt().judged() && !session.lesson().next.empty();
    now.fadedCues = own && !session.attempt().cues().faded().empty();
    now.showsFadedCues = session.attempt().cues().showsFaded();
    now.redoes = now.judges && !session.values().forScore();
    now.latch = controls.parameters.spaceLatch;
    return now;
}

void KeyGuide::add(const KeyRow& row, std::string_view pad) {
    rows_[count_] = row;
    rows_[count_++].pad = pad.empty() ? padOf(row, use_) : pad;
}

KeyGuide::KeyGuide(const KeySituation& now) : use_(useIn(now)) {
    if (now.menus) {
        addMenus(now);
        return;
    }
    if (now.demonstration || now.replay || now.cut) addPlaying(now);
    if (!now.looking && !now.cut) addTorch(now);
    const bool told = now.seam && !now.caught && !now.looking;
    if (now.lesson && !now.cut && !told) addMouse(now);
    if (now.lesson) addWeld(now);
    if (now.lesson && !now.cut) addCamera(now);
    addProgram(now);
}

void KeyGuide::addMenus(const KeySituation& now) {
    constexpr KeyHeading kHere = KeyHeading::program;
    add(keys(kHere, {Key::left, Key::right, Key::up, Key::down}, "help.choose_a_control", "bar.hint.choose",
             "help.key.arrow_keys"),
        "help.pad.pad");
    add(keys(kHere, {Key::enter}, "help.press_or_type", "bar.hint.press"));
    add(keys(kHere, {Key::backspace}, "help.first_value"));
    add(keys(kHere, {Key::escape}, "help.back_to_the_torch",
             now.seam || now.source ? "bar.hint.back_to_torch" : "bar.hint.back"));
    add(keys(kHere, {Key::tab}, "help.to_the_next_panel", "bar.hint.next_panel"));
}

void KeyGuide::addPlaying(const KeySituation& now) {
    constexpr KeyHeading kHere = KeyHeading::playing;
    if (now.cut) {
        add(keys(kHere, {Key::left, Key::right}, "help.move_the_cut", "bar.hint.move_the_cut",
                 "help.key.left_and_right"));
        return;
    }
    add(keys(kHere, {Key::space}, "help.play_or_pause", "bar.hint.play_or_pause"));
    add(keys(kHere, {Key::left, Key::right}, "help.to_another_moment", "bar.hint.to_another_moment",
             "help.key.left_and_right"));
    if (now.demonstration)
        add(keys(kHere, {Key::enter, Key::f5}, "help.weld_it_yourself", "bar.hint.weld_it_yourself"));
    else
        add(keys(kHere, {Key::f5}, "help.weld_it_yourself", "bar.hint.weld_it_yourself"));
}

void KeyGuide::addTorch(const KeySituation& now) {
    constexpr KeyHeading kHere = KeyHeading::torch;
    if (!now.seam && !now.source) return;
    const std::string_view held = now.arc ? "help.weld_while_held" : "help.heat_while_held";
    const std::string_view weld = now.arc ? "bar.hint.weld" : "bar.hint.heat";
    if (now.latch) {
        add(keys(kHere, {Key::space}, now.arc ? "help.start_or_stop_welding" : "help.start_or_stop_heating",
                 "bar.hint.start_or_stop"));
        add(mouse(kHere, "help.key.left_button", held, weld), "help.pad.right_trigger");
    } else {
        add(keys(kHere, {Key::space}, held, weld, "help.key.left_button_or_space"), "help.pad.right_trigger");
    }
    if (now.rod) add(keys(kHere, {Key::r}, "help.dip_the_rod", "bar.hint.dip_the_rod"), "help.pad.left_trigger");
    if (now.weaves)
        add(keys(kHere, {Key::g}, now.swings ? "help.stop_swinging" : "help.swing_the_torch",
                 now.swings ? "bar.hint.stop_swinging" : "bar.hint.swing"));
    if (now.source) {
        add(mouse(kHere, "help.key.mouse", "help.torch_sideways_and_up"), "help.pad.left_stick");
        add(mouse(kHere, "help.key.and_right_button", "help.torch_near_and_far", "bar.hint.near_and_far"),
            "help.pad.right_stick");
        add(keys(kHere, {Key::left, Key::right, Key::up, Key::down}, "help.torch_in_steps", {}, "help.key.arrow_keys"));
        add(keys(kHere, {Key::pageUp, Key::pageDown}, "help.torch_up_and_down", {}, "help.key.page_keys"));
        if (now.cold) add(keys(kHere, {Key::f}, "help.hot_or_cold_source"));
        return;
    }
    if (!now.caught) addMouse(now); // without it the mouse leads only while a button is held
    const std::string_view leading = now.caught ? "help.key.mouse" : "help.key.mouse_pressed";
    add(mouse(kHere, leading, "help.torch_along_the_seam", "bar.hint.along_seam"), "help.pad.left_stick");
    add(keys(kHere, {Key::shift}, "help.torch_by_keys", "bar.hint.along_seam", "help.key.shift_arrows"));
    add(keys(kHere, {Key::pageUp, Key::pageDown}, "help.torch_near_and_far", "bar.hint.arc_length",
             "help.key.wheel_or_page_keys"),
        "help.pad.shoulders");
    add(keys(kHere, {Key::left, Key::right, Key::up, Key::down}, "help.lean_the_torch", "bar.hint.lean",
             "help.key.arrow_keys"),
        "help.pad.right_stick");
}

void KeyGuide::addWeld(const KeySituation& now) {
    constexpr KeyHeading kHere = KeyHeading::weld;
    if (now.cut && now.judges) add(keys(kHere, {Key::x}, "help.close_the_cut", "bar.hint.close_the_cut"));
    if (now.seam || now.source || now.looking)
        add(keys(kHere, {Key::v}, now.looking ? "help.go_on" : "help.pause_and_look_around",
                 now.looking ? "bar.hint.work" : "bar.hint.look_around"));
    if (!now.demonstration && !now.replay) add(keys(kHere, {Key::f5}, "help.new_attempt"));
    if (now.judges) add(keys(kHere, {Key::j}, "help.judge_the_weld", now.cut ? "" : "bar.hint.judge"));
    if (now.judges && !now.cut) add(keys(kHere, {Key::x}, "help.cut_the_weld_open"));
    if (now.next) add(keys(kHere, {Key::enter}, "help.next_lesson", now.cut ? "" : "bar.hint.next_lesson"));
    if (now.fadedCues)
        add(keys(kHere, {Key::k}, now.showsFadedCues ? "help.hide_cues_again" : "help.show_hidden_cues"));
    if (now.redoes) add(keys(kHere, {Key::backspace}, "help.undo_the_last_seconds"));
}

void KeyGuide::addCamera(const KeySituation& now) {
    if (now.looking) {
        constexpr KeyHeading kHere = KeyHeading::looking;
        add(mouse(kHere, "help.key.mouse", "help.look", now.caught ? "bar.hint.look" : ""));
        add(keys(kHere, {Key::w, Key::s}, "help.forwards_and_back", "bar.hint.fly"));
        add(keys(kHere, {Key::a, Key::d}, "help.to_the_sides"));
        add(keys(kHere, {Key::q, Key::e}, "help.down_and_up"));
    } else {
        constexpr KeyHeading kHere = KeyHeading::camera;
        add(keys(kHere, {Key::a, Key::d}, "help.around_the_metal"));
        add(keys(kHere, {Key::w, Key::s}, "help.over_and_under_it"));
        add(keys(kHere, {Key::q, Key::e}, "help.nearer_and_farther"));
        if (!now.caught) add(mouse(kHere, "help.key.wheel", "help.nearer_and_farther"));
    }
}

void KeyGuide::addMouse(const KeySituation& now) {
    const bool torch = now.seam && !now.looking;
    add(keys(KeyHeading::program, {Key::c, Key::escape}, "help.catch_or_free_the_mouse",
             now.caught ? "bar.hint.free_mouse" : (torch ? "bar.hint.lock_to_torch" : "bar.hint.catch_mouse")));
}

void KeyGuide::addProgram(const KeySituation& now) {
    constexpr KeyHeading kHere = KeyHeading::program;
    if (now.home)
        add(keys(kHere, {Key::left, Key::right, Key::up, Key::down}, "help.in_the_list_of_lessons", {},
                 "help.key.arrows_enter"),
            "help.pad.pad_and_a");
    if (now.home) add(keys(kHere, {Key::tab}, "help.to_the_attempts"));
    if (now.home) add(keys(kHere, {Key::n}, "help.next_person"));
    if (!now.home && !now.lesson) {
        add(keys(kHere, {Key::enter}, "help.start_the_lesson"));
        add(keys(kHere, {Key::tab}, "help.to_the_next_control"), "help.pad.pad");
        add(keys(kHere, {Key::backspace}, "help.first_value"));
    }
    if (!now.home) add(keys(kHere, {Key::h}, "help.home_all_lessons"));
    if (!now.home && !now.lesson) add(keys(kHere, {Key::escape}, "help.home_all_lessons"));
    if (now.home) add(keys(kHere, {Key::f2}, "help.settings"));
    add(keys(kHere, {Key::f1}, "help.this_page", now.lesson ? "bar.hint.help" : ""));
    if (now.lesson) {
        add(keys(kHere, {Key::f2, Key::f3, Key::f4}, "help.view_machine_timings"));
        add(keys(kHere, {Key::tab}, "help.to_the_menus", "bar.hint.menus"));
        add(keys(kHere, {Key::f9}, "help.hide_and_show_all_panels"));
    }
    if (now.headset) add(keys(kHere, {Key::f6}, "help.view_of_the_headset"));
    add(keys(kHere, {Key::f10, Key::f12}, "help.save_the_window_the_metal_in_4k"));
    add(keys(kHere, {Key::f11}, "help.full_screen"));
}

ShortText keyRowName(const Context& context, const KeyRow& row) {
    if (context.byGamepad) return row.pad.empty() ? ShortText() : ShortText(phrase(row.pad));
    if (!row.name.empty()) return {phrase(row.name)};
    ShortText text;
    for (const Key key : row.used()) {
        if (!text.empty()) text += "  ";
        text += key < Key::left ? context.key(key) : nameOf(key);
    }
    return text;
}

} // namespace meltpool::ui
