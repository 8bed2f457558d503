// The authored form of a torch path: a TOML list of moves that a person writes.
#pragma once

#include "core/weld/torch/torch_sample.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace meltpool {

/// Hold of a filler rod before the torch: its tip comes down at an angle, from ahead, to a place in front of the
/// electrode, and goes back. Unit vectors and m, rad, Hz, m/s. The defaults are the hold that welders are taught: flat
/// over the plate, its end near the arc.
struct RodHold {
    static constexpr double kUsualAngle = 0.34906585; ///< 20 degrees

    glm::vec3 travel{1, 0, 0};  ///< direction of travel
    glm::vec3 up{0, 1, 0};      ///< direction out of the joint, at right angles to travel
    double angle = kUsualAngle; ///< angle of the rod over the plane across `up`
    double ahead = 1.5e-3;      ///< distance from the electrode's tip ahead to the dipped place
    double below = 2e-3;        ///< distance of the dipped place below the electrode's tip
    double rest = 12e-3;        ///< distance of the rod's tip from there between dips, back along the rod
    double depth = 3.5e-3;      ///< distance of a dip beyond that place
    /// Frequency of the dips, which are a cosine from rest to depth; 0: the rod stays at rest.
    double frequency = 0;
    double feed = 0; ///< see RodSample::feed

    /// Returns the rod `passed` s after the move began, for a torch with its tip there.
    RodSample sample(const glm::vec3& tip, double passed) const;
    /// Returns the rod with its end `back` m before the dipped place.
    RodSample at(const glm::vec3& tip, double back) const;
};

/// A stretch of time with one way of moving. All times s, lengths m.
struct TorchMove {
    double begin = 0;
    double duration = 0; ///< 0: only switches the trigger
    glm::vec3 from{0.0f};
    glm::vec3 to{0.0f};
    glm::quat fromOrientation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::quat toOrientation{1.0f, 0.0f, 0.0f, 0.0f}; ///< orientation at the end, turned to evenly
    float trigger = 0;
    glm::vec3 weaveSide{0.0f}; ///< unit vector across the seam; zero: no weave
    double weaveWidth = 0;     ///< width from toe to toe
    int weaveHalfSwings = 0;   ///< crossings from toe to toe in the whole move
    double weaveDwell = 0;     ///< s at each toe
    double followed = 0;       ///< length along its own axis before this move, in addition to `from` and `to`
    double follow = 0;         ///< m/s along its axis in this move, after an electrode that burns off
    std::optional<RodHold> rod;
    double pipeRadius = 0; ///< radius of the pipe whose outer face, rolled out, is the frame of this move; 0: no pipe

    /// Returns the torch `time` s after the path began; `time` inside this move.
    TorchSample sample(double time) const;

  private:
    TorchSample rolledOut(double time) const;
};

/// Reads and checks a file of moves. Throws InputError naming file and line for an unknown key or kind, a missing value
/// or one out of range.
std::vector<TorchMove> readTorchMoves(const std::filesystem::path& file);

/// Returns the orientation of a torch held at a work and a travel angle (rad) over a seam that runs along `direction`
/// (unit, not straight up). Work angle: between torch and plate in the plane across the seam, π/2 upright, less towards
/// the welder (+z). Travel angle: from there in the plane along the seam, positive pushes (the torch points in its
/// direction of travel).
glm::quat heldOrientation(double workAngle, double travelAngle, const glm::vec3& direction);

/// Returns the unit vector across a seam along `direction`, on the welder's side (+z).
glm::vec3 acrossSeam(const glm::vec3& direction);

/// Converts a torch, with its rod, from a pipe's outer face rolled out (x from the pipe's top towards +x, y out of the
/// face, z along the axis) to the workpiece's frame: all of it is turned with the frame of the face at `place` (m, the
/// x there). The pipe's axis is along z, `radius` (m) under the origin.
TorchSample aroundPipe(TorchSample torch, double place, double radius);

/// Returns the place across the seam of a weave, -1..1 of half its width: from the centre to one toe, a dwell, to the
/// other toe and back, `phase` counted in whole swings (0.25 and 0.75 are the toes). `dwellShare`: share of a swing
/// spent at one toe.
double weaveOffset(double phase, double dwellShare);

} // namespace meltpool
