#include "app/session/desk_weave.hpp"

#include <cmath>

namespace meltpool {

void DeskWeave::begin(const TorchPath& demonstration) {
    weave_ = demonstration.weave();
    on_ = swung_ = false;
    phase_ = 0;
}

double DeskWeave::next(double seconds, bool welds) {
    const bool swings = on_ && welds;
    if (!weave_ || (!swings && phase_ == 0)) return 0;
    swung_ = true;
    const double before = phase_;
    phase_ += seconds * weave_->frequency;
    if (!swings && std::floor(2 * phase_) > std::floor(2 * before)) phase_ = 0;
    phase_ -= std::floor(phase_);
    return weaveOffset(phase_, weave_->dwell * weave_->frequency) * weave_->width / 2;
}

} // namespace meltpool
