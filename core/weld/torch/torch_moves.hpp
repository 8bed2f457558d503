// The authored form of a torch path: a TOML list of moves that a person writes.
#pragma once

#include "core/weld/torch/torch_sample.hpp"

#include <filesystem>
#include <vector>

namespace meltpool {

/// A stretch of time with one way of moving. All times s, lengths m.
struct TorchMove {
    double begin = 0;
    double duration = 0; ///< 0: only switches the trigger
    glm::vec3 from{0.0f};
    glm::vec3 to{0.0f};
    glm::quat fromOrientation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::quat toOrientation{1.0f, 0.0f, 0.0f, 0.0f}; ///< turned to evenly
    float trigger = 0;
    glm::vec3 weaveSide{0.0f}; ///< unit vector across the seam; zero: no weave
    double weaveWidth = 0;     ///< toe to toe
    int weaveHalfSwings = 0;   ///< crossings from toe to toe in the whole move
    double weaveDwell = 0;     ///< s at each toe

    /// The torch `time` s after the path began; `time` inside this move.
    TorchSample sample(double time) const;
};

/// Reads and checks a file of moves. Throws InputError naming file and line for an unknown key or kind, a missing value
/// or one out of range.
std::vector<TorchMove> readTorchMoves(const std::filesystem::path& file);

/// Orientation of a torch held at a work and a travel angle (rad) over a seam that runs along `direction` (unit, not
/// straight up). Work angle: between torch and plate in the plane across the seam, π/2 upright, less towards the welder
/// (+z). Travel angle: from there in the plane along the seam, positive pushes (the torch points where it goes).
glm::quat heldOrientation(double workAngle, double travelAngle, const glm::vec3& direction);

/// Unit vector across a seam along `direction`, on the welder's side (+z).
glm::vec3 acrossSeam(const glm::vec3& direction);

/// Place across the seam of a weave, -1..1 of half its width: from the centre to one toe, a dwell, to the other toe and
/// back, `phase` counted in whole swings (0.25 and 0.75 are the toes). `dwellShare`: share of a swing spent at one toe.
double weaveOffset(double phase, double dwellShare);

} // namespace meltpool
