// Torch paths of known technique, made from closed forms.
#pragma once

#include "core/training/judging/along_seam.hpp"

#include <functional>

namespace meltpool::test {

/// A hand's pose at one moment, in the technique's quantities.
struct Hand {
    double placeMm = 0;
    double aimMm = 0;
    double workDeg = 0;
    double travelDeg = 0; ///< degrees, push positive
    double distanceMm = 12;
    bool burns = true;
    bool tracked = true;
    double rodDeg = 0;      ///< degrees over the plane across the bisector
    double rodGapMm = -1;   ///< mm from the torch's target; -1: no rod
    int direction = 1;      ///< travel direction, for travelDeg
    double tipHeightMm = 2; ///< mm along the torch's axis, from its tip to its target
};

/// Returns the torch whose axis meets the seam's height there, at these angles.
TorchSample torchOf(const Seam& seam, double time, const Hand& hand);

/// Returns a burning arc at the hand's distance, which is both its tip-to-work distance and its length; or none.
ArcState arcOf(const Hand& hand);

inline constexpr double kTimeStep = 2e-3; ///< duration of a step, s

/// Returns a weld of `seconds` with the hand as a function of time.
Technique weldWith(const Seam& seam, double seconds, const std::function<Hand(double)>& hand,
                   const TechniqueSettings& settings = {});

/// Returns a straight seam over 100 mm, up as on a plate.
Seam plateSeam();

/// Returns the mean over the judged millimetres from `fromMm` to `toMm`, in the unit of lessons. Expects at least one.
double meanOf(const std::vector<SeamMillimetre>& seam, TechniqueQuantity quantity, double fromMm = -1e9,
              double toMm = 1e9);

/// Returns the largest distance of these values from `expected`.
double farthestFrom(double expected, const std::vector<SeamMillimetre>& seam, TechniqueQuantity quantity,
                    double fromMm = -1e9, double toMm = 1e9);

} // namespace meltpool::test
