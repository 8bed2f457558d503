// The menu on the panel in the headset: the lesson's buttons, its parameters and the headset's own.
#pragma once

#include "app/headset/headset_panel.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/menu_state.hpp"
#include "xr/panel.hpp"

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace meltpool {

/// What the menu shows of the headset; borrowed for the call.
struct HeadsetMenuContent {
    Home& home;
    const ParameterSection& section; ///< the headset's own parameters
    std::string_view warning;        ///< empty: none
    std::string tipReport;           ///< of measuring the torch; empty: none
    const LessonFigures& figures;
};

/// What the person asked for in this frame.
struct HeadsetMenuAnswer {
    MenuRequest request = MenuRequest::none;
    bool recentre = false;
    bool measureTip = false;
    bool measureAxis = false;
};

class HeadsetMenu {
  public:
    /// Draws into the panel's frame buffer. `elapsed`: real seconds since the last frame.
    HeadsetMenuAnswer draw(const xr::Panel& panel, const PointerOnPanel& pointer, double elapsed,
                           LessonSession& session, const HeadsetMenuContent& content);

    /// Where the controls are, by name, in the panel's pixels, as last drawn.
    std::map<std::string, ui::Place> places() const;

  private:
    void homePart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content);
    void lessonPart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content);
    void lessonButtons(ui::Context& context, const LessonSession& session);
    void headsetPage(ui::Context& context, const HeadsetMenuContent& content);
    void pagePart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content);

    std::unique_ptr<HeadsetPanel> panel_; ///< made when it is first drawn
    HeadsetMenuAnswer answer_;
    int page_ = 0;
    size_t judgements_ = 0; ///< that were shown
};

} // namespace meltpool
