#include "core/render/effects/arc_effects.hpp"

#include <cmath>

namespace meltpool {

ArcEffects::ArcEffects() {
    sparks_.reserve(Spatter::kMostFlying + Spatter::kMostBeads + 16);
}

void ArcEffects::reset() {
    spatter_.reset();
    wire_.reset();
    puffs_.reset();
    time_ = smoke_ = 0;
}

void ArcEffects::step(const ArcEffectsStep& step) {
    time_ = step.time;
    spatter_.step(step);
    wire_.step(step);
    if (step.process != nullptr) scattering_ = traitsOf(*step.process).fume;
    puffs_.step(step, scattering_);
    const double aim = step.arc.burns() ? 1 : 0;
    smoke_ += (aim - smoke_) * (1 - std::exp(-step.seconds / kGathers));
}

ArcEffectsView ArcEffects::view() {
    sparks_.clear();
    wire_.show(sparks_);
    const size_t onTable = spatter_.show(time_, sparks_);
    const size_t puffs = puffs_.show(time_, shownPuffs_);
    return {sparks_,
            onTable,
            {scattering_ * static_cast<float>(smoke_), std::span(shownPuffs_).first(puffs), puffs_.pool()}};
}

} // namespace meltpool
