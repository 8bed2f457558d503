#include "app/desktop/desktop_menus.hpp"

#include "core/base/words.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <utility>

namespace meltpool {

namespace {

/// Share of the window; wider panels leave no room for the metal.
constexpr float kMostCovered = 0.7f;
/// Share of the window beside which a cut has no room for its figures.
constexpr float kMostBesideCut = 0.5f;
/// Share of its height that bars and a replay's or demonstration's panel may cover.
constexpr float kMostPlayed = 0.8f;

ui::KeySituation keysOf(const DesktopMenuContent& content) {
    return ui::keySituation(content.controls, content.session, content.home.open, content.headset);
}

} // namespace

float DesktopMenus::coveredLeft() {
    if (panels.result && !panels.hidden) return resultWaits_ ? 0 : ui::resultReach(interface_.context());
    const int open = static_cast<int>(panels.view) + static_cast<int>(panels.timings);
    return panels.hidden ? 0 : static_cast<float>(open) * ui::panelReach(interface_.context());
}

float DesktopMenus::coveredRight() {
    return panels.simulation && !panels.hidden && !machineWaits_ ? ui::panelReach(interface_.context()) : 0;
}

CoveredEdges DesktopMenus::covered() {
    const glm::vec2 size = glm::max(window_.size(), glm::ivec2(1));
    const float bar = panels.hidden ? 0 : ui::barHeight(interface_.context()) / size.y;
    CoveredEdges covered{coveredLeft() / size.x, coveredRight() / size.x, bar, bar};
    if (covered.left + covered.right > kMostCovered) covered.left = covered.right = 0;
    if (2 * bar > kMostCovered) covered.bottom = covered.top = 0;
    const ui::Context& context = interface_.context();
    if (plays_ && !panels.hidden)
        covered.bottom +=
            std::clamp((context.playHeight + context.points(10)) / size.y, 0.0f, std::max(kMostPlayed - 2 * bar, 0.0f));
    return covered;
}

MenuRequest DesktopMenus::draw(const DesktopMenuContent& content) {
    ui::Context& context = interface_.context();
    LessonSession& session = content.session;
    // The machine panel would cover the demonstration's controls in a narrow window.
    const Activities& activities = session.activities();
    const bool covers = activities.at(activities.demonstration) && ui::narrowerThan(context, 760);
    plays_ = session.running() && (activities.at(activities.replay) || activities.at(activities.demonstration));
    resultWaits_ = session.picture().cut().shown() &&
                   ui::resultReach(context) > kMostBesideCut * static_cast<float>(window_.size().x);
    machineWaits_ = session.picture().cut().shown() || activities.at(activities.replay) || covers;
    MenuRequest request = MenuRequest::none;
    if (content.home.open)
        request = ui::homePage(context, content.home, session.activities(), content.driver, panels);
    else if (!session.running())
        request = ui::startMenu(context, session, content.home, content.driver);
    else if (!panels.hidden)
        request = drawPanels(content);
    Question& question = session.question().asked() ? session.question() : content.seatQuestion;
    ui::questionOverlay(context, question);
    if (!std::exchange(asked_, question.asked()) && asked_) interface_.showFocus(ImGuiDir_Left);
    panels.settings = panels.settings && content.home.open;
    if (panels.settings) ui::settingsOverlay(context, panels.settings, content.viewSections);
    if (panels.help) ui::helpOverlay(context, panels.help, keysOf(content));
    const bool running = session.running();
    inLesson_ = running;
    if (!running) focused_ = false;
    occupied_ = ImGui::IsAnyItemActive() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    const bool welds = running && activities.allowed().ownTorch && session.run().arc().burns();
    ui::messageStack(context, content.messages, running ? coveredLeft() : 0, running ? coveredRight() : 0, welds);
    return request;
}

MenuRequest DesktopMenus::drawPanels(const DesktopMenuContent& content) {
    ui::Context& context = interface_.context();
    const Lesson& lesson = content.session.lesson();
    MenuRequest request = ui::topBar(context, panels, content.controls, content.session);
    ui::KeySituation keys = keysOf(content);
    keys.menus = focused_;
    ui::statusBar(context, content.figures, keys);
    if (!content.figures.caption.empty())
        ui::captionLine(context, content.figures.caption, coveredLeft(), coveredRight());
    const Activities& activities = content.session.activities();
    if (activities.at(activities.demonstration))
        if (const MenuRequest asked = ui::demonstrationBar(context, content.session, coveredLeft(), coveredRight());
            asked != MenuRequest::none)
            request = asked;
    if (activities.at(activities.replay))
        if (const MenuRequest asked = ui::replayBar(context, content.session); asked != MenuRequest::none)
            request = asked;
    ui::cueNames(context, content.session.picture().namedCues());
    ui::temperatureScale(context, lesson.look.colours, content.session.run().scene()->view().temperature,
                         coveredLeft());
    keepMachine(content);
    panels.result = panels.result && content.session.judges();
    if (!inLesson_ && coveredRight() > kMostCovered * static_cast<float>(window_.size().x)) panels.simulation = false;
    closeOverlapping();
    if (panels.result && !resultWaits_)
        if (const MenuRequest asked =
                ui::resultPanel(context, content.session, content.home, std::exchange(resultFromTop_, false));
            asked != MenuRequest::none)
            request = asked;
    if (panels.view) ui::viewMenu(context, content.viewSections);
    if (panels.simulation && !machineWaits_) ui::machineMenu(context, content.session.sections(), content.controls);
    if (panels.timings)
        ui::timingsPanel(context, content.profiler, content.figures, content.frameMs, content.driver, panels.view);
    return request;
}

/// Answers a key or button of the machine panel while the panel has nothing to set.
void DesktopMenus::keepMachine(const DesktopMenuContent& content) {
    if (inLesson_ && machineWaits_ && panels.simulation != machineBefore_) {
        panels.simulation = machineBefore_;
        const bool cut = content.session.picture().cut().shown();
        ShortText key(content.session.activities().at(content.session.activities().replay)
                          ? "desk.message.machine_replay"
                      : cut ? "desk.message.machine_cut"
                            : "desk.message.machine_no_room");
        content.messages.note(phrase(key, {{"key", interface_.context().key(Key::x)}}), content.now, "machine");
    }
    machineBefore_ = panels.simulation;
}

void DesktopMenus::focusNext() {
    const char* const next = focused_ && !panels.hidden ? interface_.context().windows.following() : ui::kTopBar;
    focused_ = true;
    panels.hidden = false;
    if (next == nullptr) return;
    ImGui::SetWindowFocus(next);
    // The bar is a row, a panel a column.
    interface_.showFocus(next == ui::kTopBar ? ImGuiDir_Down : ImGuiDir_Left);
}

void DesktopMenus::unfocus() {
    if (std::exchange(focused_, false)) ImGui::SetWindowFocus(nullptr);
}

void DesktopMenus::showResult(const LessonSession& session) {
    if (!session.judges()) return;
    panels.result = true;
    panels.hidden = false;
    resultFromTop_ = true;
}

void DesktopMenus::closeOverlapping() {
    // The result shares its place with view menu and timings: the newer replaces the older.
    if (panels.result && (panels.view || panels.timings)) {
        if (resultIsNewer_)
            panels.view = panels.timings = false;
        else
            panels.result = false;
    }
    resultIsNewer_ = !panels.result;
    // The newer of the two panels at the left replaces the older in a small window, and the panel at the right too in a
    // smaller one, or where the result and the machine would hide the weld.
    const ui::Context& context = interface_.context();
    const auto width = static_cast<float>(window_.size().x);
    const bool both = panels.view && panels.timings;
    if (both && width < 4.5f * ui::panelReach(context)) (timingsAreNewer_ ? panels.view : panels.timings) = false;
    timingsAreNewer_ = panels.view;
    const bool left = panels.result || panels.view || panels.timings;
    const float reach = panels.result ? ui::resultReach(context) : ui::panelReach(context);
    const float free = panels.result ? kMostCovered * width : width;
    if (left && panels.simulation && !machineWaits_ && free < reach + ui::panelReach(context)) {
        if (machineIsNewer_)
            panels.result = panels.view = panels.timings = false;
        else
            panels.simulation = false;
    }
    machineIsNewer_ = !panels.simulation;
}

} // namespace meltpool
