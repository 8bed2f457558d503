// The headset as the window's frame drives it: what window and headset know of each other.
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

/// A frame is begin(), the lesson's steps with torch(), draw(), end(). While the headset wants no frame, begin()
/// answers false and the others do nothing.
class WindowHeadset {
  public:
    virtual ~WindowHeadset() = default;

    /// The headset's own values, for menus and the settings file.
    virtual ParameterSection& section() = 0;

    /// Waits for the headset's next frame and reads the hands. False: there is none now, and the window continues
    /// without it. `session` may be without a running lesson. `elapsed`: real seconds since the last call.
    virtual bool begin(LessonSession& session, const Home& home, double elapsed) = 0;
    /// The torch for the lesson's steps where the hand leads it; empty: the mouse does.
    virtual TorchSource torch() = 0;
    /// Of the hand that leads the torch.
    virtual const TriggerLock& triggerLock() const = 0;
    /// Draws both eyes with the warnings of `messages`, and the panel where it is open, and sets the vibration. Answers
    /// what was asked for on the panel.
    virtual MenuRequest draw(LessonSession& session, Home& home, const LessonFigures& figures, const Messages& messages,
                             double elapsed, gl::Profiler* profiler) = 0;
    /// Where the lesson's arc is from the head, m in its directions (x to the right, z backwards). Nothing while the
    /// head is not tracked or no lesson runs.
    virtual std::optional<glm::vec3> arcFromHead(const LessonSession& session) const = 0;
    /// The size at which the workpiece is shown, 1 is real.
    virtual float zoom() const = 0;
    /// Submits the frame to the runtime.
    virtual void end() = 0;

    /// Fills the window's frame buffer of `pixels` with the left eye's picture, cut to the window's shape. False where
    /// the person does not want it or there is no picture.
    virtual bool mirror(glm::ivec2 pixels) = 0;

    /// There is no headset to be hoped for; see sentence().
    virtual bool hopeless() const = 0;
    /// How often a headset was opened.
    virtual int openings() const = 0;
    /// What the headset does, or why there is none, as a sentence.
    virtual std::string sentence() const = 0;
    /// A warning for the trainee and the teacher; empty while all is well.
    virtual std::string_view warning() const = 0;
    /// For the window's telemetry.
    virtual HeadsetStatus status() const = 0;
};

/// Makes the headset of a window whose OpenGL context is current. The argument is the folder where the torch's
/// calibrations are kept. Empty: no headset is looked for.
using HeadsetMaker = std::function<std::unique_ptr<WindowHeadset>(const std::filesystem::path& folder)>;

} // namespace meltpool
