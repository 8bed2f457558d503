// Torch paths of known technique, made from closed forms.
#pragma once

#include "core/training/judging/along_seam.hpp"

#include <functional>

namespace meltpool::test {

/// What a hand does at one moment, as the definitions of the technique's quantities have it.
struct Hand {
    double placeMm = 0;
    double aimMm = 0;
    double workDeg = 0;
    double travelDeg = 0; ///< push positive
    double distanceMm = 12;
    bool burns = true;
    bool tracked = true;
    double rodDeg = 0;      ///< over the plane across the bisector
    double rodGapMm = -1;   ///< from where the torch points; -1: no rod
    int direction = 1;      ///< of travel, for travelDeg
    double tipHeightMm = 2; ///< along the torch's axis, from its tip to where it points
};

/// The torch whose axis meets the seam's height there, at these angles.
TorchSample torchOf(const Seam& seam, double time, const Hand& hand);

/// A burning arc at the hand's distance, which is both its CTWD and its length; or none.
ArcState arcOf(const Hand& hand);

inline constexpr double kTimeStep = 2e-3; ///< s

/// A weld of `seconds`, the hand given by the time.
Technique weldWith(const Seam& seam, double seconds, const std::function<Hand(double)>& hand,
                   const TechniqueSettings& settings = {});

/// A straight seam over 100 mm, up as on a plate.
Seam plateSeam();

/// Mean over the judged millimetres from `fromMm` to `toMm`, in the unit of lessons. Expects one to be there.
double meanOf(const std::vector<SeamMillimetre>& seam, TechniqueQuantity quantity, double fromMm = -1e9,
              double toMm = 1e9);

/// Largest distance of the same values from `expected`.
double farthestFrom(double expected, const std::vector<SeamMillimetre>& seam, TechniqueQuantity quantity,
                    double fromMm = -1e9, double toMm = 1e9);

} // namespace meltpool::test
