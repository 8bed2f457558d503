#include "app/desktop/frame_pacer.hpp"

#include "core/base/work_meter.hpp"

#include <algorithm>
#include <thread>

namespace meltpool {

namespace {

/// Shortest frame, s. Few displays show more frames, and some drivers do not wait for the display: the loop would load
/// a core.
constexpr double kShortestFrame = 1.0 / 125;

} // namespace

void FramePacer::count(double seconds) {
    ++frames_;
    const double share = std::clamp(seconds * 2, 0.02, 1.0);
    frameSeconds_ += (seconds - frameSeconds_) * share;
}

void FramePacer::pace(Clock::time_point begin) const {
    const auto shortest = std::chrono::duration<double>(kShortestFrame);
    const auto rest = shortest - (Clock::now() - begin);
    if (rest <= rest.zero()) return;
    const InWork waiting(WorkPlace::waiting);
    std::this_thread::sleep_for(rest);
}

} // namespace meltpool
