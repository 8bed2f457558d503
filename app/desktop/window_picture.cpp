#include "app/desktop/window_picture.hpp"

#include "core/render/large_picture.hpp"

#include <algorithm>

namespace meltpool {

void WindowPicture::count(const LessonSession& session, double seconds, const std::optional<StepsBeside>& beside) {
    prepared_ = false;
    const double steps = session.run().clock().busy();
    const bool hurries = session.activities().current().hurries();
    const bool metalStopped = still_.count(seconds, beside || steps > 0 || hurries);
    if (!session.running()) stands_ = false;
    if (!session.running() || metalStopped) return budget_.restart();
    // A seek and a trial of the machine's speed take all the time that they can get.
    if (!counts_ || hurries) return;
    if (beside)
        return budget_.add(
            {seconds, beside->waited, 0, seconds - beside->seconds + session.run().clock().busyBeside()});
    // Real time that the steps of one second of the metal take, s.
    const double load = 1 / session.run().clock().speedOfSteps(session.run().trainer()->timeStep());
    budget_.add({seconds, steps, steps > 0 ? load : 0, 0});
}

void WindowPicture::prepare(LessonSession& session, const Controls& controls, const PictureWish& wish,
                            gl::Profiler* profiler) {
    if (wish.pixels != pixels_) budget_.restart();
    pixels_ = wish.pixels;
    const float aspect = static_cast<float>(pixels_.x) / static_cast<float>(std::max(pixels_.y, 1));
    shift_ += (wish.middle - shift_) * std::min(1.0f, static_cast<float>(wish.seconds) * 10);
    shown_ = session.picture().atDesk(controls, aspect, shift_, wish.surfaceLater, profiler);
    stands_ = still_.stands(shown_.view);
    counts_ = wish.setting == 0 && !wish.whole && !stands_;
    level_ = wish.whole          ? PictureLevel::full
             : wish.setting != 0 ? static_cast<PictureLevel>(wish.setting - 1)
             : stands_           ? PictureLevel::full
                                 : budget_.level();
    sentence_ = pictureSentence(level_);
    prepared_ = true;
}

void WindowPicture::draw(LessonSession& session, gl::Profiler* profiler) {
    session.picture().completeSurface(shown_, profiler);
    const float share = kPictureShares[static_cast<size_t>(level_)];
    const RenderTarget target = scaled_.begin(pixels_, share);
    // Figures on the cues' board are too small for fewer pixels.
    const std::span<const Marker> all = shown_.scene.markers;
    const std::span<const Marker> board = all.last(share < 1 ? shown_.boardMarkers : 0);
    shown_.scene.markers = all.first(all.size() - board.size());
    session.picture().draw(shown_, target, profiler);
    shown_.scene.markers = all;
    scaled_.end();
    session.picture().renderer().drawOver(board, {0, {0, 0, pixels_.x, pixels_.y}});
}

/// Margin, pixels; half a particle's width in the large picture is less, unless the camera is inside the metal.
constexpr int kPointMargin = 64;

Image WindowPicture::large(LessonSession& session) {
    counts_ = false; // this frame is longer than its picture
    LargePicture wish;
    wish.size = fitInto(pixels_, wish.size);
    if (session.picture().look().mode == kPointsMode) wish.margin = kPointMargin;
    View view = shown_.view;
    view.eyeToClip[2][0] += shift_.x;
    view.eyeToClip[2][1] += shift_.y;
    session.picture().setDetail(kHighDetail);
    DeskPicture tile = shown_;
    const Image image = drawLargePicture(wish, view, [&](const View& part, const RenderTarget& target) {
        tile.view = part;
        session.picture().draw(tile, target, nullptr);
    });
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return image;
}

} // namespace meltpool
