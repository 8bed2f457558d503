// Takes pictures that the person asks for: of the window with its menus, or large ones of the metal.
#pragma once

#include "app/desktop/window_picture.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"

#include <glm/vec2.hpp>

#include <string>

namespace meltpool {

class ScreenshotTaker {
  public:
    /// Requests a picture of the current frame. `large`: of the metal, see WindowPicture::large(), else of the window.
    void ask(bool large, Messages& messages);
    bool asked() const { return windowAsked_ || largeAsked_; }
    /// Returns true if a picture of the window is due, which needs all its pixels.
    bool windowAsked() const { return windowAsked_; }

    /// Saves the requested picture; a message gives its file or the reason of the failure. If `picture` is not
    /// prepared(), a picture of the window replaces a large one. `pixels`: size of the window, drawn and not yet
    /// swapped; `now` is s on the program's clock.
    void take(WindowPicture& picture, LessonSession& session, glm::ivec2 pixels, Messages& messages, double now);

    /// File of the newest saved picture; empty: none.
    const std::string& saved() const { return saved_; }
    /// Reason why the first unsaved picture failed; empty: all were saved.
    const std::string& lost() const { return lost_; }

  private:
    std::string saved_;
    std::string lost_;
    bool windowAsked_ = false;
    bool largeAsked_ = false;
};

} // namespace meltpool
