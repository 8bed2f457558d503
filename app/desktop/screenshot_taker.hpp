// Pictures that the person asks for: of the window with its menus, or large ones of the metal.
#pragma once

#include "app/desktop/window_picture.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"

#include <glm/vec2.hpp>

#include <string>

namespace meltpool {

class ScreenshotTaker {
  public:
    /// Asks for a picture of the frame under way. `large`: of the metal, see WindowPicture::large(), else of the
    /// window.
    void ask(bool large, Messages& messages);
    bool asked() const { return windowAsked_ || largeAsked_; }
    /// A picture of the window is due, which needs all its pixels.
    bool windowAsked() const { return windowAsked_; }

    /// Saves the picture asked for, and a message says where it is or why it was not saved. Where `picture`
    /// is not prepared(), a picture of the window replaces a large one. `pixels` of the window, drawn and not yet
    /// swapped; `now` is s on the program's clock.
    void take(WindowPicture& picture, LessonSession& session, glm::ivec2 pixels, Messages& messages, double now);

    /// File of the newest picture saved; empty: none was.
    const std::string& saved() const { return saved_; }
    /// Why the first picture that was not saved was not; empty: all were.
    const std::string& lost() const { return lost_; }

  private:
    std::string saved_;
    std::string lost_;
    bool windowAsked_ = false;
    bool largeAsked_ = false;
};

} // namespace meltpool
