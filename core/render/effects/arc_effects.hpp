// What flies about an arc, fed with its state step by step: spatter, the wire's drops and fume. The eye's part of what
// the ear hears.
#pragma once

#include "core/render/effects/fume_puffs.hpp"
#include "core/render/effects/spatter.hpp"
#include "core/render/effects/wire_drops.hpp"

namespace meltpool {

class ArcEffects {
  public:
    /// s in which the smoke gathers after the arc has struck, and thins out after it. None: chosen.
    static constexpr double kGathers = 0.7;

    ArcEffects();
    /// Another attempt, or another moment of this one: nothing flies or lies.
    void reset();
    void setGround(const SpatterGround& ground) {
        spatter_.setGround(ground);
        puffs_.setGround(ground);
    }
    void step(const ArcEffectsStep& step);

    /// As it is now. What it lends is valid until the next call.
    ArcEffectsView view();

    const Spatter& spatter() const { return spatter_; }

  private:
    Spatter spatter_;
    WireDrops wire_;
    double time_ = 0;
    double smoke_ = 0; ///< 0..1 of what the process gives
    float scattering_ = 0;
    FumePuffs puffs_;
    std::vector<Spark> sparks_;
    std::array<FumePuff, FumePuffs::kMost> shownPuffs_{};
};

} // namespace meltpool
