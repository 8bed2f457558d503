// What goes on between the torch's tip and the metal, from where the metal is: what hands feel and ears hear.
#pragma once

#include "core/weld/process/process.hpp"

#include <glm/vec3.hpp>

#include <limits>

namespace meltpool {

/// Where the metal lies from the tip, m in the workpiece's frame; infinite where there is none in reach.
struct TipSounding {
    float ahead = std::numeric_limits<float>::infinity();   ///< along the torch's axis; negative: the tip is inside
    float nearest = std::numeric_limits<float>::infinity(); ///< in any direction; negative: inside
    float liquid = 0;                                       ///< share of liquid where the torch points, 0..1
    glm::vec3 normal{0, 1, 0};                              ///< out of the metal at its nearest place
};

/// How near a process wants its tip to the metal, m.
struct TipGap {
    float radius = 0;    ///< of what touches: wire, electrode, soldering tip
    float steady = 0;    ///< right length of arc; 0: no arc
    float shortest = 0;  ///< below it the wire's drops bridge the arc; 0: never
    float heatReach = 0; ///< without arc: how far from the tip heat still reaches metal
};

/// Where an arc begins to break, and where it is out, as multiples of its right length.
inline constexpr float kBreakingArc = 2.5F;
inline constexpr float kBrokenArc = 5;

TipGap tipGap(const ProcessParameters& parameters);

enum class TipAction {
    idle,     ///< no heat, or none that arrives
    burning,  ///< arc, flame or iron at work
    shorting, ///< so near that the wire's drops bridge the arc again and again
    stubbed,  ///< the wire pushes against the metal
    breaking, ///< an arc so long that it goes out now and then
};

struct TipState {
    TipAction action = TipAction::idle;
    float power = 0;   ///< 0..1 of what the process can give: what arrives in the metal
    float stretch = 0; ///< of an arc, 0 right or shorter .. 1 about to break
    float liquid = 0;  ///< share of liquid where the torch points, 0..1
};

/// Pure: the same trigger (0..1) over the same metal is the same state. An arc touches the metal out: a TIG electrode
/// that dips in, as one farther off than kBrokenArc, gives nothing.
TipState tipState(const TipGap& gap, float trigger, const TipSounding& sounding);

/// Notices when the tip meets the metal, whether heat is on or not.
class TipTouch {
  public:
    /// Takes the newest sounding, `elapsed` seconds after the last. `velocity`: of the tip, m/s as the hand moves it.
    void update(const TipGap& gap, const TipSounding& sounding, const glm::vec3& velocity, double elapsed);
    /// Nothing is known of the metal until the next update; metal that the tip is in then was not touched.
    void forget() { known_ = touching_ = false; }

    bool touching() const { return touching_; }
    /// Seconds since the tip met the metal; infinite before the first time.
    double since() const { return since_; }
    /// m/s, towards the metal, at that moment.
    float speed() const { return speed_; }
    /// How often it did.
    unsigned count() const { return count_; }

  private:
    bool known_ = false; ///< a tip that is inside at the first look did not get there by a touch
    bool touching_ = false;
    double since_ = std::numeric_limits<double>::infinity();
    float speed_ = 0;
    unsigned count_ = 0;
    float approach_ = 0; ///< fastest of late, m/s: the answer about the metal comes when the hand has already stopped
};

} // namespace meltpool
