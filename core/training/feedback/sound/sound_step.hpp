// Holds the audible part of a step: the arc's state, and the other sounds at torch and workpiece.
#pragma once

#include "core/training/feedback/sound/short_circuits.hpp"
#include "core/weld/process/arc.hpp"
#include "core/weld/process/processes.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <array>
#include <optional>

namespace meltpool {

/// One audible step. Small and without allocated memory, so that a thread can hand it to another one.
struct SoundStep {
    double seconds = 0;                     ///< length of the step
    const ProcessTraits* process = nullptr; ///< null: silence
    ArcState arc;
    float trigger = 0;     ///< 0 released .. 1: gas flows, the machine is on
    float dropRate = 0;    ///< 1/s, drops from the wire into an open arc
    bool withoutGas = false; ///< see Equipment::withoutGas()
    float alternating = 0; ///< Hz of the machine's alternating current; 0: direct current
    float tipSpeed = 0;    ///< speed of the tip, m/s
    float hottest = 0;     ///< hottest temperature of the metal, K; 0: unknown
    int chips = 0;         ///< strokes of the chipping hammer that begin in this step
    double shortPhase = 0; ///< phase of the short circuits, see ShortCircuits::phase()
    size_t shortCount = 0; ///< used entries of `shorts`
    std::array<ShortCircuit, ShortCircuits::kMost> shorts{};

    std::span<const ShortCircuit> shortCircuits() const { return {shorts.data(), shortCount}; }
};

/// Drops a second of a wire of `diameter` (m) fed at `speed` (m/s) into an open arc of `current` (A) in this gas: below
/// the current of spray a drop is about twice as thick as the wire, above it as thick as the wire (globular and
/// projected spray, as in the drawings of welding handbooks; between them it changes over kSprayRange as the width of
/// the heat does).
double wireDropRate(double diameter, double speed, double current, const ShieldingGas& gas);

/// Makes the audible steps of a lesson. Equal steps give equal sounds, to the last bit.
class SoundSource {
  public:
    /// `alternating`: processes whose machine gives alternating current weld with it.
    void setAlternating(bool alternating) { alternating_ = alternating; }
    void reset();
    /// `hottest`: hottest temperature of the metal, K.
    void step(const ProcessSettings& settings, const ArcState& arc, const TorchSample& torch, double seconds,
              double hottest);

    const SoundStep& last() const { return last_; }
    /// Saves or restores everything except last(), for a checkpoint.
    void transfer(gl::StateArchive& archive);
    const ShortCircuits& shorts() const { return shorts_; }

  private:
    ShortCircuits shorts_;
    SoundStep last_;
    std::optional<glm::vec3> tip_; ///< tip of the torch in the last step
    bool alternating_ = false;
};

} // namespace meltpool
