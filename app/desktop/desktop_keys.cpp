// Handles the keys whose meaning depends on the open page; all others are keys of actions, see desktopActions().
#include "app/desktop/desktop_app.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

/// Handles the keys of the list of attempts: Enter plays the chosen row, Escape gives up what is open.
void DesktopApp::moveInAttempts(const InputFrame& input) {
    ReplayList& list = home_.attempts;
    Activities& activities = session_.activities();
    const auto struck = [&](Key key) {
        return std::find(input.struck.begin(), input.struck.end(), key) != input.struck.end();
    };
    const bool compares = activities.at(activities.comparison);
    const bool atRow = list.rowFocused || !ImGui::GetIO().NavVisible; // else Enter is for a button
    const bool idle = !compares && !list.choosing && list.asking == ReplayList::Asking::nothing;
    if (struck(Key::enter) && idle && atRow && list.selected()) {
        list.choose(*list.selected());
        act(MenuRequest::replay);
    }
    if (!struck(Key::escape)) return;
    if (compares)
        activities.endComparison();
    else if (list.asking != ReplayList::Asking::nothing)
        list.asking = ReplayList::Asking::nothing;
    else if (!list.choosing) // Dear ImGui itself closes the open lessons
        list.hide();
}

/// Handles the keys of the pages before a lesson runs.
void DesktopApp::moveByKeys(const InputFrame& input) {
    if (menus_.panels.overlaid()) return;
    const bool tab = std::find(input.struck.begin(), input.struck.end(), Key::tab) != input.struck.end();
    if (tab && !ui::Steering::kTabMoves && keysChoose()) interface_.showFocus(ImGuiDir_Down);
    if (home_.open && home_.who.asked()) return answerByKeys(input);
    if (home_.open && home_.attempts.shown()) return moveInAttempts(input);
    if (home_.open && tab) {
        ImGui::SetWindowFocus("home");
        interface_.showFocus(ImGuiDir_Left);
        return home_.attempts.show();
    }
    for (const Key key : input.pressed) {
        if (!home_.open) break;
        home_.move((key == Key::right) - (key == Key::left), (key == Key::down) - (key == Key::up));
    }
    // Dear ImGui itself takes Enter for the control chosen by keys.
    if (std::find(input.struck.begin(), input.struck.end(), Key::enter) == input.struck.end()) return;
    if (home_.open)
        act(MenuRequest::openLesson);
    else if (!ImGui::GetIO().NavVisible)
        act(MenuRequest::start);
}

/// Handles the keys of the question for a name, as far as its field does not take them: Enter accepts, Escape leaves
/// it.
void DesktopApp::answerByKeys(const InputFrame& input) {
    const auto struck = [&](Key key) {
        return std::find(input.struck.begin(), input.struck.end(), key) != input.struck.end();
    };
    if (struck(Key::escape)) return home_.who.close();
    if (struck(Key::enter) && !ImGui::GetIO().NavVisible && home_.who.takeTyped()) act(MenuRequest::welder);
}

/// Handles the keys of the demonstration: pause, its time, and Enter for one's own attempt.
void DesktopApp::demonstrateByKeys(const InputFrame& input) {
    if (menus_.panels.overlaid()) return;
    Demonstration& demonstration = session_.activities().demonstration;
    for (const Key key : input.pressed) {
        if (key == Key::left) demonstration.moveTo(demonstration.time() - Demonstration::kKeyStep);
        if (key == Key::right) demonstration.moveTo(demonstration.time() + Demonstration::kKeyStep);
    }
    for (const Key key : input.struck) {
        if (key == Key::space) demonstration.toggle();
        if (key == Key::enter) act(MenuRequest::reset);
    }
}

/// Handles the keys of a saved attempt: pause and its time.
void DesktopApp::replayByKeys(const InputFrame& input) {
    if (menus_.panels.overlaid()) return;
    ReplayTimeline& line = session_.activities().replay.line();
    for (const Key key : input.pressed) {
        if (key == Key::left) line.seek(line.target() - ReplayTimeline::kKeyStep);
        if (key == Key::right) line.seek(line.target() + ReplayTimeline::kKeyStep);
    }
    if (std::find(input.struck.begin(), input.struck.end(), Key::space) != input.struck.end()) line.toggle();
}

/// Handles the key of a judged attempt: Enter for the next lesson.
void DesktopApp::goOnByKeys(const InputFrame& input) {
    if (menus_.panels.overlaid() || !menus_.panels.result || !session_.attempt().judged() || session_.welds()) return;
    if (session_.question().asked() || seats_.question(Seat::desk).asked()) return;
    if (std::find(input.struck.begin(), input.struck.end(), Key::enter) != input.struck.end()) act(MenuRequest::next);
}

/// True if keys choose controls: on the pages before a lesson, in a running lesson's menus, and at a question. In the
/// list of lessons the program itself takes arrow keys and Enter.
bool DesktopApp::keysChoose() {
    const bool asked = session_.question().asked() || seats_.question(Seat::desk).asked();
    if (asked || menus_.panels.overlaid()) return true;
    return session_.running() ? menus_.focused() : !home_.open || home_.attempts.shown() || home_.who.asked();
}

GamepadUse DesktopApp::gamepadUse() {
    if (!session_.running() || keysChoose()) return GamepadUse::menus;
    if (session_.picture().cut().shown()) return GamepadUse::cut;
    return session_.activities().allowed().ownTorch ? GamepadUse::torch : GamepadUse::playing;
}

/// Takes away the input that chooses controls in a running lesson.
void DesktopApp::keepFromTorch(InputFrame& input) {
    if (!session_.running() || !keysChoose()) return;
    const auto chooses = [all = menus_.focused()](Key key) {
        const bool steers = (key >= Key::left && key <= Key::down) || key == Key::enter || key == Key::space;
        return steers || (all && key < Key::f1 && key != Key::escape && key != Key::tab);
    };
    std::erase_if(input.pressed, chooses);
    std::erase_if(input.struck, chooses);
    for (size_t i = 0; i < input.held.size(); ++i)
        if (chooses(static_cast<Key>(i))) input.held[i] = false;
    const GamepadFrame gamepad = std::exchange(input.gamepad, {});
    input.gamepad.connected = gamepad.connected;
}

void DesktopApp::handleKeys(const InputFrame& input) {
    const Activities& activities = session_.activities();
    if (!session_.running())
        moveByKeys(input);
    else if (activities.at(activities.replay))
        replayByKeys(input);
    else if (activities.at(activities.demonstration))
        demonstrateByKeys(input);
    else
        goOnByKeys(input);
    for (const Key key : input.struck)
        act(key);
}

} // namespace meltpool
