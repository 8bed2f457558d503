// The drop that grows at the wire's end, and those on their way from there into the pool.
#pragma once

#include "core/render/effects/spatter.hpp"

namespace meltpool {

/// Drops of a wire. Between two short circuits the drop grows until it touches; in an open arc it falls off.
class WireDrops {
  public:
    /// Greatest drawn diameter of a drop, in wire diameters: a larger one would hide the arc.
    static constexpr double kThickest = 1.6;

    void reset() { *this = {}; }
    void step(const ArcEffectsStep& step);
    /// Appends the drop at the wire's end, then those in flight. No-op for a process without a wire.
    void show(std::vector<Spark>& sparks) const;

    /// Returns the diameter (m) of a grown drop: a wire of `diameter` (m) that is fed at `speed` (m/s) gives `rate` of
    /// them a second: speed pi d²/4 = rate pi D³/6.
    static double dropDiameter(double diameter, double speed, double rate);

  private:
    bool burns_ = false;
    double phase_ = 0;    ///< number of drops that have left the wire
    double rate_ = 0;     ///< 1/s
    double diameter_ = 0; ///< m, diameter of a grown drop
    float wire_ = 0;      ///< m, diameter of the wire
    float speed_ = 0;     ///< m/s at which drops fall
    float gap_ = 0;       ///< m from the wire's end to the metal
    glm::vec3 end_{0}, axis_{0, -1, 0};
};

} // namespace meltpool
