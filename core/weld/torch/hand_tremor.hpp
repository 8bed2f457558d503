// The tremor of a hand that holds a torch.
#pragma once

#include "core/weld/torch/torch_sample.hpp"

#include <array>
#include <cstdint>

namespace meltpool {

/// A sum of three swings of 7 to 9 Hz on each axis (physiological tremor of the hand: 8 to 12 Hz, slower with a load in
/// it). One seed gives one tremor on every machine.
class HandTremor {
  public:
    static constexpr double kPlace = 3e-4;  ///< m, root mean square on each axis, of a practised hand
    static constexpr double kAngle = 0.035; ///< rad, root mean square about each of two axes

    explicit HandTremor(std::uint32_t seed);

    /// Moves and turns the torch as the hand trembles at `time` s. `place`: m, `angle`: rad, root mean squares.
    void shake(TorchSample& torch, double time, double place, double angle) const;

  private:
    struct Swing {
        double frequency = 0; ///< Hz
        double phase = 0;     ///< rad
    };
    static constexpr size_t kSwings = 3;
    static constexpr size_t kAxes = 5; ///< three axes of place, two of angle

    double swing(size_t axis, double time) const;

    std::array<std::array<Swing, kSwings>, kAxes> swings_{};
};

} // namespace meltpool
