// The window's menus: home page, start menu, bars, panels and messages, and how much of the picture they cover.
#pragma once

#include "app/desktop/interface.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/menu_state.hpp"
#include "app/ui/panels.hpp"
#include "core/render/framing.hpp"

#include <glm/vec2.hpp>

#include <span>
#include <string>

namespace meltpool {

/// Content that the menus show and change; borrowed for the call.
struct DesktopMenuContent {
    LessonSession& session;
    Home& home;
    Controls& controls;
    Messages& messages;
    const LessonFigures& figures;
    const gl::Profiler& profiler;
    double frameMs = 0;
    const std::string& driver;                             ///< name of the graphics driver
    std::span<const ParameterSection* const> viewSections; ///< sections of the view menu
    Question& seatQuestion;                                ///< question before an action ends the trainee's weld
    bool headset = false;                                  ///< a headset is in use
    double now = 0;                                        ///< s on the program's clock
};

class DesktopMenus {
  public:
    DesktopMenus(const Window& window, ui::Interface& theInterface) : window_(window), interface_(theInterface) {}

    PanelState panels;

    /// Draws every open panel. Returns the person's request.
    MenuRequest draw(const DesktopMenuContent& content);

    /// Opens the result panel if the lesson has one.
    void showResult(const LessonSession& session);

    /// Gives the keys to the menus of the running lesson: to the top bar, then to the next open panel each time.
    void focusNext();
    /// Gives the keys back to the torch.
    void unfocus();
    bool focused() const { return focused_; }
    /// Like unfocus(), unless Escape ends something within the menus: a list, the typing of a number.
    void leaveFocus() {
        if (!occupied_) unfocus();
    }

    /// Edges of the window that panels and bars cover. Panels that leave no room for the metal do not count.
    CoveredEdges covered();

  private:
    MenuRequest drawPanels(const DesktopMenuContent& content);
    void keepMachine(const DesktopMenuContent& content);
    void closeOverlapping();
    float coveredLeft();
    float coveredRight();

    const Window& window_;
    ui::Interface& interface_;
    /// The machine panel is not drawn: its values would change nothing (weld cut open, attempt replayed), or it has no
    /// room.
    bool machineWaits_ = false;
    bool resultWaits_ = false;     ///< the result is not drawn until the cut, beside which it has no room, is closed
    bool machineBefore_ = false;   ///< the machine panel was open in the last frame
    bool plays_ = false;           ///< a replay's or demonstration's panel is shown
    bool focused_ = false;         ///< keys choose controls of the running lesson
    bool occupied_ = false;        ///< a control is being changed or a list is open, in the last frame
    bool asked_ = false;           ///< a question was shown in the last frame
    bool resultFromTop_ = false;   ///< the next frame shows the result's top
    bool resultIsNewer_ = false;   ///< the result opened after the panels at its place
    bool timingsAreNewer_ = false; ///< choice if both panels at the left are open in the next frame
    bool machineIsNewer_ = false;  ///< the machine panel opened after a panel at the left
    bool inLesson_ = false;        ///< the last frame showed a running lesson
};

} // namespace meltpool
