#include "app/activities/curve_track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

void CurveTrack::begin(double duration) {
    values_.assign(kPlaces, std::numeric_limits<float>::quiet_NaN());
    duration_ = duration;
    least_ = most_ = 0;
    known_ = false;
}

void CurveTrack::add(double time, double value) {
    if (!(duration_ > 0) || !std::isfinite(value) || !(time >= 0)) return;
    const double share = std::min(time / duration_, 1.0);
    const size_t place = std::min(static_cast<size_t>(share * kPlaces), kPlaces - 1);
    const auto number = static_cast<float>(value);
    values_[place] = number;
    least_ = known_ ? std::min(least_, number) : number;
    most_ = known_ ? std::max(most_, number) : number;
    known_ = true;
}

} // namespace meltpool
