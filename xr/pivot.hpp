// Calibrates the pivot of a torch's tip: the torch is turned about its resting tip, and least squares gives the offset.
#pragma once

#include "xr/pose.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace meltpool::xr {

struct PivotResult {
    bool accepted = false;
    std::string reason;    ///< reason of a refusal, as a sentence for the person; empty if accepted
    glm::vec3 offset{0};   ///< m, from the grip (or tracker) to the tip in the grip's own frame
    glm::vec3 point{0};    ///< m, place of the resting tip
    float residualMm = 0;  ///< root mean square distance of the tips from that point
    float errorMm = 0;     ///< standard error of the offset (its length in space), estimated from the residual
    float turnDegrees = 0; ///< angle about the axis of the least turning
};

/// Solves R_i * offset + p_i = point for all poses in the least-squares sense (6 unknowns, 3 equations a pose). Refuses
/// fewer than 20 poses; a torch that was not turned by about 15 degrees about two axes, since the offset along a common
/// axis is undetermined; a residual above 5 mm, since the tip slid; and an offset whose standard error exceeds
/// kPivotError. For independent noise of equal variance in all directions this is the best linear unbiased estimate
/// (Gauss-Markov theorem).
PivotResult solvePivot(std::span<const Pose> poses);

constexpr float kPivotError = 0.3f; ///< mm

struct AxisResult {
    bool accepted = false;
    std::string reason;            ///< reason of a refusal, as in PivotResult
    glm::vec3 direction{0, 0, -1}; ///< unit vector of the torch's direction, in the grip's own frame
    float spreadDegrees = 0;       ///< root mean square angle of the single poses from it
};

/// The direction of a torch that is held with its tip straight down: the mean of `down` (a unit vector in the poses'
/// space) in the grip's frame. Refuses fewer than 20 poses and a spread of more than 3 degrees.
AxisResult solveAxis(std::span<const Pose> poses, const glm::vec3& down = {0, -1, 0});

/// The pose of a torch's tip in the grip's frame; its -Z is the torch's axis.
struct TipCalibration {
    glm::vec3 offset{0.0f};            ///< m, in the grip's frame
    glm::quat orientation{1, 0, 0, 0}; ///< orientation of the tip pose in the grip's frame
    float residualMm = 0;

    /// Turns the torch's axis to this unit vector of the grip's frame by the smallest rotation.
    void pointAlong(const glm::vec3& direction);

    /// The tip pose of a grip pose.
    Pose tip(const Pose& grip) const { return grip * Pose{orientation, offset}; }
};

/// One calibration as a text file of `key = value` lines in mm. Throws InputError (file, line, expectation).
TipCalibration readCalibration(const std::filesystem::path& file);
void writeCalibration(const std::filesystem::path& file, const TipCalibration& calibration);

} // namespace meltpool::xr
