#include "app/desktop/picture/window_picture.hpp"

namespace meltpool {

void WindowPicture::count(const LessonSession& session, double seconds) {
    if (!session.running()) return budget_.restart();
    // A seek and a trial of the machine's speed take all the time that they can get.
    if (!counts_ || session.seeks() || session.measuresSpeed()) return;
    budget_.add({seconds, session.clock().busy(), session.clock().busy() > 0 ? session.loadOfSteps() : 0});
}

void WindowPicture::draw(LessonSession& session, const Controls& controls, const PictureWish& wish,
                         gl::Profiler* profiler) {
    if (wish.pixels != pixels_) budget_.restart();
    pixels_ = wish.pixels;
    counts_ = wish.setting == 0 && !wish.whole;
    const PictureLevel level = wish.whole          ? PictureLevel::full
                               : wish.setting == 0 ? budget_.level()
                                                   : static_cast<PictureLevel>(wish.setting - 1);
    const RenderTarget target = scaled_.begin(wish.pixels, kPictureShares[static_cast<size_t>(level)]);
    session.draw(controls, target, wish.shift, profiler);
    scaled_.end();
    sentence_ = pictureSentence(level);
}

} // namespace meltpool
