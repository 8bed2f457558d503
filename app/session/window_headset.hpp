// The headset as the window's frame drives it: the interface between window and headset.
#pragma once

#include "app/session/headset_status.hpp"
#include "app/session/home.hpp"
#include "app/session/lesson_figures.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"
#include "app/session/trigger_lock.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// The headset of a window. A frame is begin(), the lesson's steps with torch(), draw(), end(). While the headset wants
/// no frame, begin() returns false and the others are no-ops.
class WindowHeadset {
  public:
    virtual ~WindowHeadset() = default;

    /// Values of the headset itself, for menus and the settings file.
    virtual ParameterSection& section() = 0;

    /// Waits for the headset's next frame and reads the hands. False: there is none now, and the window continues
    /// without it. `session` may have no running lesson. `elapsed`: s of real time since the last call.
    virtual bool begin(LessonSession& session, const Home& home, double elapsed) = 0;
    /// Torch for the lesson's steps if the hand leads it; empty: the mouse does.
    virtual TorchSource torch() = 0;
    /// Lock of the hand that leads the torch.
    virtual const TriggerLock& triggerLock() const = 0;
    /// Draws both eyes with the warnings of `messages`, and the panel if it is open, and sets the vibration. Returns
    /// the request made on the panel.
    virtual MenuRequest draw(LessonSession& session, Home& home, const LessonFigures& figures, const Messages& messages,
                             double elapsed, gl::Profiler* profiler) = 0;
    /// Position of the lesson's arc relative to the head, m in its directions (x to the right, z backwards). Nothing
    /// while the head is not tracked or no lesson runs.
    virtual std::optional<glm::vec3> arcFromHead(const LessonSession& session) const = 0;
    /// Scale at which the workpiece is shown; 1 is real.
    virtual float zoom() const = 0;
    /// Submits the frame to the runtime.
    virtual void end() = 0;

    /// Shows a question on the panel until it is answered; null: none. `question` must outlive this or the next call.
    virtual void ask(Question* question) = 0;

    /// Fills the window's frame buffer of `pixels` with what the left eye sees, panel and notice too, cut to the
    /// window's shape. Returns false if the window shows its own camera or there is no picture. Throws InputError if
    /// the shaders cannot be used.
    virtual bool mirror(glm::ivec2 pixels, gl::ShaderLibrary& shaders) = 0;
    /// Turns to the next choice of what the window shows: by itself, its own camera, the trainee's eye. Returns a
    /// sentence about it.
    virtual std::string_view nextDeskView() = 0;

    /// True if no headset can be expected; see sentence().
    virtual bool hopeless() const = 0;
    /// Count of times a headset was opened.
    virtual int openings() const = 0;
    /// Sentence about the headset's activity, or why there is none.
    virtual std::string sentence() const = 0;
    /// Warning for the trainee and the teacher; empty without one.
    virtual std::string_view warning() const = 0;
    /// State for the window's telemetry.
    virtual HeadsetStatus status() const = 0;
};

/// Makes the headset of a window whose OpenGL context is current. The argument is the folder of the torch's
/// calibrations. Empty: no headset is looked for.
using HeadsetMaker = std::function<std::unique_ptr<WindowHeadset>(const std::filesystem::path& folder)>;

} // namespace meltpool
