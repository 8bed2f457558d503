// Worsens a torch path: faster, farther off, turned, off the seam, with a trembling hand.
#pragma once

#include "core/training/judging/seam.hpp"
#include "core/weld/torch/hand_tremor.hpp"
#include "core/weld/torch/torch_path.hpp"

#include <cstdint>

namespace meltpool {

struct PathPerturbation {
    double time = 1;                         ///< factor of the path's duration
    double farther = 0;                      ///< m, back along the torch's own axis
    double turn = 0;                         ///< rad, about the seam; positive leans the handle to the welder
    double aside = 0;                        ///< m, across the seam; positive to the welder's side
    std::uint32_t tremor = 0;                ///< seed of a hand's tremor; 0: no tremor
    double tremorPlace = HandTremor::kPlace; ///< m, root mean square on each axis
    double tremorAngle = HandTremor::kAngle; ///< rad, root mean square about each axis
};

/// Samples a bent path.
class PerturbedPath {
  public:
    PerturbedPath(const TorchPath& path, const Seam& seam, const PathPerturbation& bend);

    /// The torch at `time` s of the bent path.
    TorchSample sample(double time) const;
    double duration() const { return path_.duration() * bend_.time; }

  private:
    const TorchPath& path_;
    const Seam& seam_;
    PathPerturbation bend_;
    HandTremor tremor_;
};

} // namespace meltpool
