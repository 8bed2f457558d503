// Counts the wire's short circuits one by one from the arc's state, once for ear and hand.
#pragma once

#include "core/gl/state_archive.hpp"
#include "core/weld/process/arc.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace meltpool {

/// Returns false for a wire that strikes, stubs or has no arc: only the others have short circuits that end.
bool ignitesAgain(ArcAction action);

/// The end of a short circuit: the arc ignites again.
struct ShortCircuit {
    float at = 0;    ///< s after the step's start
    float power = 0; ///< W, the jump of electric power
};

/// Makes single short circuits from the rate in the arc's state. They come at that rate, but not evenly: the time to
/// the next one varies by kUnevenness, as that of real ones does, by numbers that depend on the count alone, so that
/// equal steps give equal short circuits. Copies continue alike.
class ShortCircuits {
  public:
    /// Listed short circuits of one step, at most. More are counted, but not listed.
    static constexpr size_t kMost = 16;
    /// Largest deviation of the time between two of them, as a share of the mean. Source: none, chosen.
    static constexpr double kUnevenness = 0.3;

    void reset() { *this = {}; }
    /// Takes the state of a step of `seconds`. A wire that strikes or stubs does not ignite again. `controlled`: the
    /// machine ends each short circuit; they come evenly, at kControlledBreakCurrent.
    void step(const ArcState& arc, double seconds, bool controlled = false);

    /// Short circuits of the last step, in the order of time.
    std::span<const ShortCircuit> last() const { return {last_.data(), listed_}; }
    /// Short circuits since the start.
    std::uint64_t count() const { return count_; }
    /// The count plus the share of the time to the next one: grows steadily while the wire shorts.
    double phase() const { return static_cast<double>(count_) + way_ / next_; }

    /// Saves or restores everything except last(), for a checkpoint.
    void transfer(gl::StateArchive& archive) { archive.values(count_, way_, next_); }

  private:
    std::array<ShortCircuit, kMost> last_{};
    size_t listed_ = 0;
    std::uint64_t count_ = 0;
    double way_ = 0;  ///< time since the last short circuit, in mean intervals
    double next_ = 1; ///< time from the last to the next one, in mean intervals
};

} // namespace meltpool
