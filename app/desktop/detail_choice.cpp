#include "app/desktop/detail_choice.hpp"

#include "core/base/words.hpp"

#include <algorithm>
#include <array>

namespace meltpool {

namespace {

/// Pictures before a level's pictures count: the driver compiles programs, and the card's times arrive some pictures
/// late.
constexpr int kFirst = 6;
constexpr int kCounted = 6; ///< pictures of which the quickest counts: others may have waited for the metal's steps

} // namespace

std::span<const std::string_view> detailChoices() {
    static constexpr std::array<std::string_view, 4> kChoices{"automatic", "low", "medium", "high"};
    return kChoices;
}

std::string_view detailSentence(PictureDetail level) {
    static constexpr std::array<std::string_view, 3> kKeys{"desk.detail.low", "desk.detail.medium", ""};
    const std::string_view key = kKeys[static_cast<size_t>(level)];
    return key.empty() ? key : phrase(key);
}

void DetailTrial::restart() {
    level_ = software_ ? kLowDetail : kHighDetail;
    settled_ = software_;
    pictures_ = 0;
}

void DetailTrial::add(double picture, double frame) {
    if (settled_ || ++pictures_ <= kFirst) return;
    least_ = pictures_ == kFirst + 1 ? picture : std::min(least_, picture);
    if (pictures_ < kFirst + kCounted) return;
    pictures_ = 0;
    if (least_ > kShare * frame) level_ = static_cast<PictureDetail>(level_ - 1);
    settled_ = least_ <= kShare * frame || level_ == kLowDetail;
}

void DetailChoice::update(int setting, bool running, bool headset) {
    if (!running || headset != headset_) trial_.restart();
    setting_ = setting;
    headset_ = headset;
}

PictureDetail DetailChoice::level() const {
    return setting_ == 0 ? trial_.level() : static_cast<PictureDetail>(setting_ - 1);
}

void DetailChoice::count() {
    const gl::PassTime* pass = timer_.find("picture");
    if (pass == nullptr || pass->frames == seen_) return;
    seen_ = pass->frames;
    trial_.add(pass->lastMs * 1e-3, headset_ ? kHeadsetFrame : kWindowFrame);
}

} // namespace meltpool
