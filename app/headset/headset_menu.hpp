// Draws the menu on the panel in the headset: the lesson's buttons, its parameters and the headset's own.
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

/// Content of the menu about the headset; borrowed for the call.
struct HeadsetMenuContent {
    Home& home;
    const ParameterSection& section; ///< the headset's own parameters
    std::string_view warning;        ///< empty: none
    std::string tipReport;           ///< report of the torch's measuring; empty: none
    bool tipMeasured = false;        ///< a measured tip is in use
    const LessonFigures& figures;
    bool leftHanded;    ///< the left hand holds the torch
    bool dimmed;        ///< the person works beside the panel, or watches the arc through a dark visor
    Question* question; ///< question before an action ends the teacher's weld; null: none
};

/// Requests of the person in this frame.
struct HeadsetMenuAnswer {
    MenuRequest request = MenuRequest::none;
    bool recentre = false;
    bool measureTip = false;
    bool measureAxis = false;
    bool ownTip = false; ///< forget the measured tip
};

class HeadsetMenu {
  public:
    /// Draws into the panel's frame buffer. `elapsed`: real seconds since the last frame.
    HeadsetMenuAnswer draw(const xr::Panel& panel, const PointerOnPanel& pointer, double elapsed,
                           LessonSession& session, const HeadsetMenuContent& content);

    /// Returns the places of the controls, by name, in the panel's pixels, as last drawn.
    std::map<std::string, ui::Place> places() const;

  private:
    void homePart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content);
    void lessonPart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content);
    void lessonButtons(ui::Context& context, const LessonSession& session);
    void legend(ui::Context& context, const Lesson* lesson, const HeadsetMenuContent& content);
    void legendPart(ui::Context& context, const LessonSession& session, const HeadsetMenuContent& content);
    void headsetPage(ui::Context& context, const HeadsetMenuContent& content);
    void pagePart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content);

    /// Content of the panel: another one is shown from its top.
    struct Shown {
        bool home = false, running = false;
        size_t judgements = 0;
        bool operator==(const Shown&) const = default;
    };

    std::unique_ptr<HeadsetPanel> panel_; ///< made at the first draw
    Shown shown_;
    HeadsetMenuAnswer answer_;
    int page_ = 0;
    bool lessonSeen_ = false; ///< a lesson's page has been drawn
    bool judgedAnew_ = false; ///< the number of judgements has changed since the pages were last drawn
};

} // namespace meltpool
