#include "app/desktop/screenshot_taker.hpp"

#include "app/desktop/screenshot.hpp"
#include "core/base/words.hpp"

#include <exception>
#include <utility>

namespace meltpool {

void ScreenshotTaker::ask(bool large, Messages& messages) {
    (large ? largeAsked_ : windowAsked_) = true;
    messages.clear("picture"); // the last picture's message does not belong to this one
}

void ScreenshotTaker::take(WindowPicture& picture, LessonSession& session, glm::ivec2 pixels, Messages& messages,
                           double now) {
    const bool large = std::exchange(largeAsked_, false) && picture.prepared();
    windowAsked_ = false;
    try {
        saved_ = (large ? savePicture(picture.large(session)) : saveScreenshot(pixels)).string();
        messages.note(phrase("desk.message.picture_saved", {{"file", saved_}}), now, "picture");
    } catch (const std::exception& fault) {
        messages.warn(fault.what(), now, "picture");
        if (lost_.empty()) lost_ = fault.what();
    }
}

} // namespace meltpool
