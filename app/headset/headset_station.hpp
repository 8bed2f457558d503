// The headset as the window's frame sees it: the desk's side, the panel in space and the lesson between them.
#pragma once

#include "app/headset/headset_desk.hpp"
#include "app/headset/headset_panel.hpp"
#include "app/headset/headset_status.hpp"
#include "app/session/session.hpp"

#include <memory>
#include <string>

namespace meltpool {

/// A window frame calls begin(), lets the lesson advance with torch(), then draw() and end(). Everything is harmless
/// while there is no headset.
class HeadsetStation {
  public:
    /// `folder`: where the torch's calibration is kept.
    explicit HeadsetStation(const std::filesystem::path& folder);

    /// The headset's own values, for menus and the settings file.
    const ParameterSection& section() const { return section_; }
    ParameterSection& section() { return section_; }

    /// True while the headset wants a frame; `session` may be without a running lesson.
    bool begin(const Session& session, double elapsed) { return desk_.begin(session.bottom(), elapsed); }
    /// The torch for the lesson's steps where the hand leads it; empty: the mouse does.
    HeldTorchAt torch() const;
    /// Both eyes, and the panel where it is open. `figures` are shown on it. Answers what was asked for there.
    MenuRequest draw(Session& session, const LessonFigures& figures, double elapsed, gl::Profiler* profiler);
    void end() { desk_.end(); }

    /// Puts the trainee's view into the window where that is wished and there is one.
    bool mirror(glm::ivec2 pixels);

    /// For the window's telemetry.
    HeadsetStatus status() const;

    HeadsetDesk& desk() { return desk_; }
    const HeadsetDesk& desk() const { return desk_; }

  private:
    TipStatus tipStatus() const;
    MenuRequest drawPanel(Session& session, const LessonFigures& figures, double elapsed);
    MenuRequest panelContent(ui::Context& context, Session& session, const LessonFigures& figures);

    HeadsetParameters parameters_;
    ParameterSection section_;
    HeadsetDesk desk_;
    std::unique_ptr<HeadsetPanel> panel_;
    int page_ = 0;
    bool mirrored_ = false;
};

} // namespace meltpool
