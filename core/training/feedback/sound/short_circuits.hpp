// The short circuits of the wire, one by one: counted once from the arc's state, and read by ear and hand.
#pragma once

#include "core/gl/state_archive.hpp"
#include "core/weld/process/arc.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace meltpool {

/// The end of a short circuit: the arc ignites again.
struct ShortCircuit {
    float at = 0;    ///< s after the step's beginning
    float power = 0; ///< W, the step of electric power
};

/// The arc's state has a rate of short circuits; this makes single ones of it. They come as often as the rate says, but
/// not evenly: the time to the next one varies by kUnevenness, as that of real ones does, by numbers that follow from
/// the count alone, so that the same steps give the same short circuits. Copies go on alike.
class ShortCircuits {
  public:
    /// Of one step, at most. More are counted, but not listed.
    static constexpr size_t kMost = 16;
    /// Share by which the time between two of them differs from the mean, at most. None: chosen.
    static constexpr double kUnevenness = 0.3;

    void reset() { *this = {}; }
    /// Takes the state of a step of `seconds`. A wire that only strikes or stubs does not ignite again.
    void step(const ArcState& arc, double seconds);

    /// Those of the last step, in the order of time.
    std::span<const ShortCircuit> last() const { return {last_.data(), listed_}; }
    /// Since the start.
    std::uint64_t count() const { return count_; }
    /// The count, and the share of the way to the next one: grows steadily while the wire shorts.
    double phase() const { return static_cast<double>(count_) + way_ / next_; }

    /// For a checkpoint: all but last().
    void transfer(gl::StateArchive& archive) { archive.values(count_, way_, next_); }

  private:
    std::array<ShortCircuit, kMost> last_{};
    size_t listed_ = 0;
    std::uint64_t count_ = 0;
    double way_ = 0;  ///< mean times between short circuits since the last one
    double next_ = 1; ///< of them to the next one
};

} // namespace meltpool
