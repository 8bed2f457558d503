// What is seen to fly about the arc, from the same step that is heard: one arc for eye and ear.
#pragma once

#include "core/render/effects/arc_effects.hpp"
#include "core/render/scene.hpp"
#include "core/training/feedback/sound/sound_step.hpp"

namespace meltpool {

class Sight {
  public:
    /// Takes over what the metal's scene says of workpiece and table. What the scene lends of them must outlive this.
    void open(const SceneView& metal);
    /// Another attempt, or another moment of this one. Spatter is no part of a checkpoint: after a seek nothing flies
    /// or lies but what comes from there on, which is the same as it was.
    void reset() { effects_.reset(); }
    /// `heard`: the step, with its short circuits; `number`: steps since the start.
    void step(const ProcessSettings& process, const SoundStep& heard, const TorchSample& torch, std::uint64_t number);

    /// As after the last step. What it lends is valid until the next call.
    ArcEffectsView view() { return effects_.view(); }
    const ArcEffects& effects() const { return effects_; }

  private:
    ArcEffects effects_;
};

} // namespace meltpool
