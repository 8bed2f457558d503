// Finding a torch's tip: the tip is held on one point, the torch is turned about it, least squares gives the offset.
#pragma once

#include "xr/pose.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace meltpool::xr {

struct PivotResult {
    bool accepted = false;
    std::string reason;    ///< why not, as a sentence for the person; empty where accepted
    glm::vec3 offset{0};   ///< m, from the grip (or tracker) to the tip in the grip's own frame
    glm::vec3 point{0};    ///< m, where the tip was held
    float residualMm = 0;  ///< root mean square distance of the tips from that point
    float turnDegrees = 0; ///< how far the torch was turned about its least turned axis
};

/// Solves R_i * offset + p_i = point for all poses in the least-squares sense (6 unknowns, 3 equations a pose). Refuses
/// fewer than 20 poses, a torch that was not turned by some 15 degrees about two axes (the offset along a common axis
/// would be free), and a residual above 5 mm (the tip slid).
PivotResult solvePivot(std::span<const Pose> poses);

/// The tip's place on a torch: the offset and the direction the torch's axis (-Z of the tip pose) takes in the grip's
/// frame.
struct TipCalibration {
    glm::vec3 offset{0.0f, 0.0f, -0.12f}; ///< m, in the grip's frame
    glm::quat orientation{1, 0, 0, 0};    ///< of the tip pose in the grip's frame
    float residualMm = 0;

    /// The tip pose of a grip pose.
    Pose tip(const Pose& grip) const { return grip * Pose{orientation, offset}; }
};

/// One calibration as a text file of `key = value` lines in mm. Throws InputError (file, line, expectation).
TipCalibration readCalibration(const std::filesystem::path& file);
void writeCalibration(const std::filesystem::path& file, const TipCalibration& calibration);

} // namespace meltpool::xr
