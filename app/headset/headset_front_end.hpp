// The headset beside the window: one object that the window's frame drives, whether a headset is there, asleep, lost or
// in use.
#pragma once

#include "app/headset/headset_hands.hpp"
#include "app/headset/headset_menu.hpp"
#include "app/headset/headset_status.hpp"
#include "app/headset/panel_pointer.hpp"
#include "app/headset/stereo_view.hpp"
#include "app/headset/torch_feedback.hpp"
#include "app/session/lesson_session.hpp"
#include "xr/headset_connection.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// A frame is begin(), the lesson's steps with torch(), draw(), end(). While the headset wants no frame, begin()
/// answers false and the others do nothing.
class HeadsetFrontEnd {
  public:
    /// Looks for a headset from the first begin() on. `folder`: where the torch's calibrations are kept.
    explicit HeadsetFrontEnd(const std::filesystem::path& folder);

    /// The headset's own values, for menus and the settings file.
    const ParameterSection& section() const { return section_; }
    ParameterSection& section() { return section_; }

    /// Waits for the headset's next frame and reads the hands. False: there is none now, and the window continues
    /// without it. `session` may be without a running lesson. `elapsed`: real seconds since the last call.
    bool begin(const LessonSession& session, double elapsed);
    /// The torch for the lesson's steps where the hand leads it; empty: the mouse does.
    TorchSource torch() const;
    /// Draws both eyes, and the panel where it is open, and sets the vibration. Answers what was asked for on the
    /// panel.
    MenuRequest draw(LessonSession& session, const LessonFigures& figures, double elapsed, gl::Profiler* profiler);
    /// Submits the frame to the runtime.
    void end();

    /// Fills the window's frame buffer of `pixels` with the left eye's picture, cut to the window's shape. False where
    /// the person does not want it or there is no picture.
    bool mirror(glm::ivec2 pixels);

    /// How often a headset was opened.
    int openings() const { return connection_.openings(); }
    /// What the headset does, or why there is none, as a sentence.
    std::string sentence() const;
    /// A warning for the trainee and the teacher; empty while all is well.
    std::string_view warning() const;
    /// For the window's telemetry.
    HeadsetStatus status() const;

  private:
    using Clock = std::chrono::steady_clock;

    void guarded(FunctionRef<void()> work);
    void readHands(double elapsed);
    void placeWorkshop();
    bool leadsTorch() const { return inFrame_ && hands_.torch().known(); }
    void drawEyes(LessonSession& session, double elapsed, gl::Profiler* profiler);
    MenuRequest drawMenu(LessonSession& session, const LessonFigures& figures, double elapsed);
    bool blitLeftEye(glm::ivec2 pixels) const;

    HeadsetParameters parameters_;
    ParameterSection section_;
    xr::HeadsetConnection connection_;
    Workshop workshop_;
    WorkpiecePlace place_;
    HeadsetHands hands_;
    PanelPointer panel_;
    StereoView view_;
    TorchFeedback feedback_;
    HeadsetMenu menu_;
    xr::FrameTiming timing_;
    bool inFrame_ = false;
    bool drawn_ = false;    ///< the eyes hold a picture that the runtime shows
    bool mirrored_ = false; ///< the window shows it too
    double busy_ = 0;       ///< s, of the last frame's begin() and draw() without waiting for the runtime
};

} // namespace meltpool
