#include "app/desktop/desktop_headset.hpp"

#include "core/base/error.hpp"

namespace meltpool {

namespace {

/// Longest time that a requested headset may take to open, s: far beyond its time on a busy machine.
constexpr double kHeadsetPatience = 120;

} // namespace

void DesktopHeadset::open(const DesktopOptions& options, const std::filesystem::path& folder) {
    wanted_ = options.headset == HeadsetUse::wanted;
    if (options.headset != HeadsetUse::off && options.makeHeadset) headset_ = options.makeHeadset(folder);
}

bool DesktopHeadset::begin(LessonSession& session, const Home& home, Messages& messages, double seconds, double now) {
    frame_ = headset_ && headset_->begin(session, home, seconds);
    if (!headset_) return false;
    if (wanted_ && headset_->openings() == 0 && (headset_->hopeless() || now > kHeadsetPatience))
        throw InputError("there is no headset to use: " + headset_->sentence());
    if (headset_->warning().empty())
        messages.clear("headset");
    else
        messages.hold(headset_->warning(), "headset");
    const bool first = frame_ && !started_;
    started_ = started_ || frame_;
    return first;
}

} // namespace meltpool
