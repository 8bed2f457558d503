#include "app/desktop/desktop_actions.hpp"

#include "app/desktop/desktop_app.hpp"
#include "core/base/words.hpp"

namespace meltpool {

std::span<const DesktopAction> desktopActions() {
    using App = DesktopApp;
    using Request = MenuRequest;
    constexpr auto always = [](const App&) { return true; };
    // A slip of the welder's own hand; for another's weld a question comes.
    constexpr auto noWelding = [](const App& app) {
        return !app.session_.welds() || app.session_.leader() == TorchLeader::hand;
    };
    constexpr auto mayAskName = [](const App& app) { return app.home_.open && !app.home_.who.asked(); };
    static constexpr DesktopAction table[] = {
        {"lesson list", Request::home, Key::h, noWelding, [](App& app) { app.goHome(); }},
        {"open lesson",
         Request::openLesson,
         {},
         always,
         [](App& app) { app.lessons_.open(app.home_.chosen(), app.clock_.now()); }},
        {"next lesson", Request::next, {}, always, [](App& app) { app.openNext(); }},
        {"start", Request::start, {}, always, [](App& app) { app.start(&LessonSession::begin); }},
        {"start with the lesson's values",
         Request::startWithDefaults,
         {},
         always,
         [](App& app) { app.startWithDefaults(); }},
        {"demonstration", Request::demonstrate, {}, always, [](App& app) { app.start(&LessonSession::demonstrate); }},
        {"replay", Request::replay, {}, always, [](App& app) { app.replay(); }},
        {"weld beside a kept attempt", Request::ghost, {}, always, [](App& app) { app.weldBeside(); }},
        {"compare", Request::compare, {}, always, [](App& app) { app.lessons_.compare(app.clock_.now()); }},
        {"page of a kept attempt",
         Request::keptPage,
         {},
         always,
         [](App& app) { app.lessons_.showKeptPage(app.clock_.now()); }},
        {"table of attempts", Request::exportAttempts, {}, always, [](App& app) { app.lessons_.exportAttempts(); }},
        {"new attempt", Request::reset, Key::f5, always, [](App& app) { app.reset(); }},
        {"lesson page", Request::restart, {}, always, [](App& app) { app.leave(); }},
        {"judge", Request::judge, Key::j, always, [](App& app) { app.judge(); }},
        {"page of the attempt",
         Request::page,
         {},
         always,
         [](App& app) { app.lessons_.writePage(app.driver_, app.clock_.now()); }},
        {"pause", Request::pause, {}, always, [](App& app) { app.togglePause(); }},
        {"try the remedy", Request::tryCure, {}, always, [](App& app) { app.tryCure(); }},
        {"redo", Request::redo, Key::backspace, always, [](App& app) { app.redo(); }},
        {"hidden cues", Request::none, Key::k, always, [](App& app) { app.session_.attempt().cues().toggleFaded(); }},
        {"cut", Request::cut, Key::x, always, [](App& app) { app.cut(); }},
        {"next person", Request::none, Key::n, mayAskName, [](App& app) { app.home_.who.ask(); }},
        {"person", Request::welder, {}, always, [](App& app) { app.welders_.enter(app.clock_.now()); }},
        {"back", Request::none, Key::escape, always, [](App& app) { app.goBack(); }},
        {"keys to the menus", Request::none, Key::tab, always, [](App& app) { app.toMenus(); }},
        {"hide panels", Request::none, Key::f9, always, [](App& app) { app.hidePanels(); }},
        {"help", Request::none, Key::f1, always, [](App& app) { app.toggle(&PanelState::help); }},
        {"view menu", Request::none, Key::f2, always, [](App& app) { app.toggleViewOrSettings(); }},
        {"machine menu", Request::none, Key::f3, always, [](App& app) { app.toggle(&PanelState::simulation); }},
        {"timings", Request::none, Key::f4, always, [](App& app) { app.toggle(&PanelState::timings); }},
        {"view of the headset", Request::none, Key::f6, always, [](App& app) { app.switchDeskView(); }},
        {"full screen", Request::none, Key::f11, always, [](App& app) { app.window_.toggleFullScreen(); }},
        {"picture of the window", Request::none, Key::f10, always,
         [](App& app) { app.screenshots_.ask(false, app.messages_); }},
        {"large picture", Request::none, Key::f12, always,
         [](App& app) { app.screenshots_.ask(app.mayStandStill(), app.messages_); }},
    };
    return table;
}

void DesktopApp::act(MenuRequest request, Seat seat) {
    if (request == MenuRequest::none) return;
    for (const DesktopAction& action : desktopActions())
        if (action.request == request && seats_.allows(seat, request)) perform(action, seat);
}

void DesktopApp::act(Key key) {
    for (const DesktopAction& action : desktopActions())
        if (action.key == key && action.allowed(*this) && seats_.allows(Seat::desk, action.request))
            perform(action, Seat::desk);
}

void DesktopApp::perform(const DesktopAction& action, Seat seat) {
    const bool nothing = (action.request == MenuRequest::home && home_.open) ||
                         (action.request == MenuRequest::redo && !session_.redoes()) ||
                         (action.request == MenuRequest::judge && !session_.judges()) ||
                         (action.request == MenuRequest::reset && !session_.running());
    if (!nothing) seats_.note(seat, action.request, clock_.now());
    // A redone weld goes on; every other end of an attempt keeps its score.
    if (endsAttempt(action.request) && action.request != MenuRequest::redo && finishJudging() &&
        action.request == MenuRequest::reset)
        return messages_.note(phrase("desk.message.judged_first"), clock_.now(), "attempt");
    action.run(*this);
}

/// Pauses the lesson for both people, or goes on with it.
void DesktopApp::togglePause() {
    if (session_.running()) controls_.setMode(controls_.mode() == Mode::view ? Mode::interact : Mode::view);
}

void DesktopApp::switchDeskView() {
    if (headset_.device()) messages_.note(std::string(headset_.device()->nextDeskView()), clock_.now(), "desk view");
}

void DesktopApp::goHome() {
    lessons_.goHome();
    menus_.panels.help = menus_.panels.settings = menus_.panels.result = false;
}

void DesktopApp::tryCure() {
    lessons_.tryCure(clock_.now());
    menus_.panels.help = menus_.panels.result = false;
}

void DesktopApp::openNext() {
    if (const CataloguedLesson* next = home_.find(session_.lesson().next)) lessons_.open(*next, clock_.now());
    menus_.panels.result = false;
}

void DesktopApp::start(void (LessonSession::*begin)(Controls&)) {
    if (lessons_.start(begin, clock_.now())) showAll();
}

void DesktopApp::startWithDefaults() {
    session_.sections().restoreDefaults();
    start(&LessonSession::begin);
}

void DesktopApp::replay() {
    if (lessons_.replay(home_.attempts.chosen(), clock_.now())) showAll();
}

void DesktopApp::weldBeside() {
    if (lessons_.weldBeside(home_.attempts.chosen(), clock_.now())) showAll();
}

void DesktopApp::reset() {
    messages_.clear("attempt");
    if (session_.activities().at(session_.activities().replay))
        start(&LessonSession::begin);
    else
        session_.reset(controls_);
    if (!session_.attempt().judged() && !session_.question().asked()) menus_.panels.result = false;
    controls_.takeBackMouse();
}

/// Goes back in the attempt; the person reads that one which passed stays as it is.
void DesktopApp::redo() {
    const int attempt = session_.log().records().attempt();
    session_.redo(controls_);
    if (session_.log().records().attempt() != attempt)
        messages_.note(phrase("desk.message.redone_apart"), clock_.now(), "attempt");
}

void DesktopApp::leave() {
    lessons_.leave();
    menus_.panels.help = menus_.panels.settings = menus_.panels.result = false;
    profiler_.reset();
}

void DesktopApp::judge() {
    session_.judge();
    menus_.showResult(session_);
}

void DesktopApp::cut() {
    session_.toggleCut(controls_);
    if (session_.picture().cut().shown()) menus_.showResult(session_);
}

/// Closes help and settings, gives the keys back to the torch, or leaves the lesson's page.
void DesktopApp::goBack() {
    PanelState& panels = menus_.panels;
    // On the list of lessons itself Escape belongs to what is open there.
    if (!home_.open && !session_.running() && !panels.overlaid()) goHome();
    if (!panels.overlaid() && menus_.focused()) {
        menus_.leaveFocus();
        controls_.putOut(ArcOut::panel);
    }
    panels.help = panels.settings = false;
}

/// Lets keys choose in the menus of the running lesson, while the torch is still and out.
void DesktopApp::toMenus() {
    if (!session_.running()) return;
    controls_.releaseMouse();
    controls_.putOut(ArcOut::panel);
    menus_.focusNext();
}

void DesktopApp::toggle(bool PanelState::*panel) {
    menus_.panels.*panel = !(menus_.panels.*panel);
}

/// The list of lessons has the program's settings, a lesson has its view menu.
void DesktopApp::toggleViewOrSettings() {
    toggle(home_.open ? &PanelState::settings : &PanelState::view);
}

void DesktopApp::hidePanels() {
    menus_.panels.hidden = session_.running() && !menus_.panels.hidden;
    if (menus_.panels.hidden) menus_.unfocus();
}

/// Shows all panels and resets the timings, for a lesson's start.
void DesktopApp::showAll() {
    menus_.panels.hidden = false;
    profiler_.reset();
}

/// Returns true if the frame may pause for seconds. A large picture takes that long if the processor draws. An attempt
/// with a burning arc would lose the hand's movement in that time.
bool DesktopApp::mayStandStill() const {
    if (!session_.running() || headset_.inFrame()) return false;
    return !window_.driver().software || !session_.welds();
}

} // namespace meltpool
