// Computes the loudness of each sound from the steps of a lesson: the one state that the synthesis plays and the
// captions name.
#pragma once

#include "core/training/feedback/sound/sound_step.hpp"

namespace meltpool {

/// Power of the loudest arc, W.
inline constexpr float kFullArcPower = 5000;

/// Levels are root mean squares of full scale, before the person's volume. Levels of real arcs differ far more: here a
/// trainee must hear the quiet ones too. No source gives their ratios; they are chosen.
struct SoundLevels {
    float hiss = 0;         ///< noise of the open arc, louder with its length
    float hissPitch = 0;    ///< Hz, centre of its band, higher with the arc's length
    float drops = 0;        ///< hum of the drops
    float dropRate = 0;     ///< 1/s
    float crackle = 0;      ///< pops of a covered electrode
    float crackleRate = 0;  ///< 1/s
    float cracklePitch = 0; ///< Hz, centre of the band of its pops
    float buzz = 0;         ///< hum of alternating current
    float buzzRate = 0;     ///< Hz, twice the current's
    float roar = 0;         ///< roar of the flame
    float gas = 0;          ///< shielding gas, also before and after the arc
    float stub = 0;         ///< wire that pushes against the metal
    float scratch = 0;      ///< electrode that is drawn over the metal without an arc

    bool silent() const;
};

/// Follows the steps: the levels of the present sounds, and the sounds that begin in a step.
class SoundState {
  public:
    /// Cooling of the metal's hottest place between two ticks, K, while it is below kTickBelow. Source: none, chosen.
    static constexpr float kTickStep = 25;
    static constexpr float kTickBelow = 1100;

    void step(const SoundStep& step);

    const SoundLevels& levels() const { return levels_; }
    /// Power of a strike that begins in the last step, W; 0: no strike.
    float strike() const { return strike_; }
    /// Ticks of the cooling metal that begin in the last step.
    int ticks() const { return ticks_; }
    /// True if the gas flows without an arc.
    bool gasAlone() const { return levels_.gas > 0 && !arc_; }

  private:
    void followGas(const SoundStep& step);
    void followCooling(const SoundStep& step);

    SoundLevels levels_;
    float strike_ = 0;
    int ticks_ = 0;
    bool arc_ = false;
    double postFlow_ = 0; ///< s of gas flow left
    float lastTick_ = 0;  ///< K, at the last tick; 0 while the metal does not cool
};

} // namespace meltpool
