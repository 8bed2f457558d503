// What is heard of a step of the metal: the arc's state, and what else sounds at torch and workpiece.
#pragma once

#include "core/training/feedback/sound/short_circuits.hpp"
#include "core/weld/process/arc.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <array>
#include <optional>

namespace meltpool {

/// One step, for ears. Small and without memory of its own, so that a thread can hand it to another one.
struct SoundStep {
    double seconds = 0;                     ///< length of the step
    const ProcessTraits* process = nullptr; ///< null: nothing sounds
    ArcState arc;
    float trigger = 0;     ///< 0 released .. 1: gas flows, the machine is on
    float dropRate = 0;    ///< 1/s, drops that leave the wire of an open arc
    float alternating = 0; ///< Hz of the machine's alternating current; 0: direct current
    float tipSpeed = 0;    ///< m/s
    float hottest = 0;     ///< K of the metal; 0: not known
    int chips = 0;         ///< strokes of the chipping hammer that begin in this step
    double shortPhase = 0; ///< see ShortCircuits::phase()
    size_t shortCount = 0; ///< of `shorts` that are used
    std::array<ShortCircuit, ShortCircuits::kMost> shorts{};

    std::span<const ShortCircuit> shortCircuits() const { return {shorts.data(), shortCount}; }
};

/// Drops a second of a wire of `diameter` (m) that is fed at `speed` (m/s) into an open arc of `current` (A): below the
/// current of spray a drop is about twice as thick as the wire, above it as thick (globular and projected spray, as
/// welding handbooks draw them; between them it changes over kSprayRange as the width of the heat does).
double wireDropRate(double diameter, double speed, double current);

/// Makes what is heard of a lesson's steps. The same steps give the same, to the last bit.
class SoundSource {
  public:
    /// `alternating`: the metal is welded with alternating current by processes whose machine gives it.
    void setAlternating(bool alternating) { alternating_ = alternating; }
    void reset();
    /// `hottest`: of the metal, K.
    void step(const ProcessSettings& settings, const ArcState& arc, const TorchSample& torch, double seconds,
              double hottest);

    const SoundStep& last() const { return last_; }
    /// For a checkpoint: all but last().
    void transfer(gl::StateArchive& archive);
    const ShortCircuits& shorts() const { return shorts_; }

  private:
    ShortCircuits shorts_;
    SoundStep last_;
    std::optional<glm::vec3> tip_; ///< of the torch in the last step
    bool alternating_ = false;
};

} // namespace meltpool
