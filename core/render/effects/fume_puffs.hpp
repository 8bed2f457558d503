// Puffs of smoke that rise from an arc. They follow closed forms from their birth; nothing of them is stepped.
#pragma once

#include "core/render/effects/flight.hpp"
#include "shaders/shared/effects.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace meltpool {

struct ArcEffectsStep;

/// The plume over a point source of heat in still air (Morton, Taylor, Turner 1956, Proc. R. Soc. Lond. A 234, 1-23,
/// their solution with even profiles): half as wide as 6/5 of the entrainment times the height, and as fast as
/// 5/(6 a) (9/10 a F)^(1/3) z^(-1/3) with the entrainment a and the flux of buoyancy F over pi.
struct FumePlume {
    static constexpr double kEntrains = 0.1;
    /// Growth of the half width, m per m of height.
    static constexpr double kWidens = 1.2 * kEntrains;

    /// Returns the speed at a height of 1 m over a source of `power` (W) that goes into the air, m^(4/3)/s: F = g power
    /// / (pi rho cp T).
    static double speedAtMetre(double power);
    /// Returns the height (m) over the source, `age` s after passing `from` (m), of air that rises at `speedAtMetre`
    /// z^(-1/3).
    static double height(double from, double speedAtMetre, double age);
};

class FumePuffs {
  public:
    /// 1/s while the arc burns; each puff takes a period to come out of the arc. No source: chosen, so that puffs
    /// overlap.
    static constexpr double kRate = 24;
    /// s after which all of them are gone; most reach kHighest before.
    static constexpr double kLongest = 1.5;
    /// Largest number at once: the births in kLongest, and one more.
    static constexpr size_t kMost = 37;
    static_assert(double(kMost) >= kRate * kLongest + 1);
    /// Heights (m) over the arc from which on puffs thin out, and at which they are gone; likewise shares of kLongest.
    static constexpr double kThins = 0.16, kHighest = 0.32;
    /// Half width of the plume at the arc, m: about an arc's radius.
    static constexpr double kSource = 4e-3;
    /// Radius of a puff in half widths of the plume: towards its edge it is thin. No source: chosen.
    static constexpr double kSpreads = 1.5;

    void reset() { *this = FumePuffs(ground_); }
    /// Sets the blocks under which smoke cannot rise; they must outlive this.
    void setGround(const SpatterGround& ground) { ground_ = ground; }

    /// Advances by one step. `scattering`: of the process's smoke, see ProcessTraits::fume; 0: none is born.
    void step(const ArcEffectsStep& step, float scattering);

    /// Writes the puffs at `time` s after the lesson's beginning to `puffs`, the oldest first; returns their number.
    size_t show(double time, std::array<FumePuff, kMost>& puffs) const;

    /// Returns the last place of the burning arc, m.
    const glm::vec3& pool() const { return pool_; }

    FumePuffs() = default;

  private:
    struct Puff {
        std::int64_t number = -1; ///< number k of the moment k / kRate at which it was born; -1: none
        glm::vec3 from{0};        ///< m
        glm::vec3 aside{0};       ///< offset from the plume's axis, in half widths of the plume, level
        float seen = 0;           ///< m²: scattering cross-section of all its smoke
        float speedAtMetre = 0;   ///< see FumePlume
        float ceiling = 0;        ///< m over `from` at which a block ends its rise
    };

    explicit FumePuffs(const SpatterGround& ground) : ground_(ground) {}
    Puff born(const ArcEffectsStep& step, std::int64_t number) const;
    FumePuff shown(const Puff& puff, double age) const;

    SpatterGround ground_;
    std::array<Puff, kMost> puffs_;
    std::int64_t newest_ = -1;
    glm::vec3 pool_{0};
};

} // namespace meltpool
