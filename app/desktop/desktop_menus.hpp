// The window's menus: home page, start menu, bars, panels and messages, and how much of the picture they cover.
#pragma once

#include "app/desktop/interface.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/menu_state.hpp"
#include "app/ui/panels.hpp"

#include <span>
#include <string>

namespace meltpool {

/// What the menus show and change; borrowed for the call.
struct DesktopMenuContent {
    LessonSession& session;
    Home& home;
    Controls& controls;
    Messages& messages;
    const LessonFigures& figures;
    const gl::Profiler& profiler;
    double frameMs = 0;
    const std::string& driver;                             ///< name of the graphics driver
    std::span<const ParameterSection* const> viewSections; ///< for the view menu
};

class DesktopMenus {
  public:
    DesktopMenus(const Window& window, ui::Interface& theInterface) : window_(window), interface_(theInterface) {}

    PanelState panels;

    /// Draws all that is open. Answers what the person asked for.
    MenuRequest draw(const DesktopMenuContent& content);

    /// Opens the result panel, where the lesson has one.
    void showResult(const LessonSession& session);

    /// How far the middle of the uncovered part of the window is right of the window's middle, as a share of half the
    /// window's width.
    float middleOfPicture();

  private:
    MenuRequest drawPanels(const DesktopMenuContent& content);
    void makeRoom();
    float coveredLeft();
    float coveredRight();

    const Window& window_;
    ui::Interface& interface_;
    /// Its values would change nothing, where the weld is cut open or an attempt replayed, or it has no room.
    bool machineWaits_ = false;
    bool resultIsNewer_ = false;   ///< than the panels at its place
    bool timingsAreNewer_ = false; ///< if both panels at the left are open in the next frame
    bool machineIsNewer_ = false;  ///< than a panel at the left
};

} // namespace meltpool
