// Particles and fume about an arc, fed with its state step by step: spatter, the wire's drops and smoke. The visible
// part of the sounds.
#pragma once

#include "core/render/effects/fume_puffs.hpp"
#include "core/render/effects/spatter.hpp"
#include "core/render/effects/wire_drops.hpp"

namespace meltpool {

class ArcEffects {
  public:
    /// s in which the smoke gathers after the arc has struck, and thins out after it. No source: chosen.
    static constexpr double kGathers = 0.7;

    ArcEffects();
    /// Clears all drops, beads and smoke, for another attempt or another moment of this one.
    void reset();
    void setGround(const SpatterGround& ground) {
        spatter_.setGround(ground);
        puffs_.setGround(ground);
    }
    void step(const ArcEffectsStep& step);

    /// Returns the effects as they are now. The lent data is valid until the next call.
    ArcEffectsView view();

    const Spatter& spatter() const { return spatter_; }

  private:
    Spatter spatter_;
    WireDrops wire_;
    double time_ = 0;
    double smoke_ = 0; ///< 0..1 of the process's full smoke
    float scattering_ = 0;
    FumePuffs puffs_;
    std::vector<Spark> sparks_;
    std::array<FumePuff, FumePuffs::kMost> shownPuffs_{};
};

} // namespace meltpool
