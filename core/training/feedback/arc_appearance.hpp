// Shows the sparks of the arc, from the steps that the sound plays: one arc for eye and ear.
#pragma once

#include "core/render/effects/arc_effects.hpp"
#include "core/render/scene.hpp"
#include "core/training/feedback/sound/sound_step.hpp"

namespace meltpool {

class ArcAppearance {
  public:
    /// Takes workpiece and table from the metal's scene. Objects that the scene lends must outlive this.
    void open(const SceneView& metal);
    /// Starts another attempt, or another moment of this one. Spatter is not part of a checkpoint: after a seek only
    /// new spatter is shown, equal to the original one.
    void reset() { effects_.reset(); }
    /// `heard`: the step, with its short circuits; `number`: steps since the start.
    void step(const ProcessSettings& process, const SoundStep& heard, const TorchSample& torch, std::uint64_t number);

    /// The view after the last step. Its references are valid until the next call.
    ArcEffectsView view() { return effects_.view(); }
    const ArcEffects& effects() const { return effects_; }

  private:
    ArcEffects effects_;
};

} // namespace meltpool
