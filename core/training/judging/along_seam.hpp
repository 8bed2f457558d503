// Divides technique by the millimetre of the seam, for drawing, scoring and technique.csv.
#pragma once

#include "core/training/judging/technique.hpp"
#include "core/weld/gauge/weld_shape.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

/// s of unbroken arc that count as struck; shorter flashes before are not judged.
inline constexpr double kStrikeSeconds = 0.5;
/// m after the strike that are not judged, at least the first kStrikeSeconds: the pool forms there.
inline constexpr double kStrikeLength = 3e-3;
/// m before the arc's last end that are not judged: the crater is filled there.
inline constexpr double kCraterLength = 3e-3;

/// A whole millimetre of the seam that the arc passed.
struct SeamMillimetre {
    double place = 0;       ///< m, its centre
    double seconds = 0;     ///< arc time on it
    bool judged = false;    ///< outside strike and crater, and the hand is known there
    bool known = true;      ///< false: the hand is unknown there, and the values with it
    int direction = 0;      ///< direction of travel: +1 towards growing places, -1, 0 unknown
    double current = 0;     ///< A of the arc, mean over the time there
    double voltage = 0;     ///< V of the arc, mean over the time there
    TechniqueValues values; ///< means over the time there; over the judged steps if there are any
};

/// The attempt so far, in ascending places, without the millimetres that had no arc. Unlike Technique::now() this also
/// uses the steps after each step: the speed's window is centred on it, within its stretch of arc (which ends when the
/// arc goes out, tracking is lost, samples are missing or the torch jumps); aim is the centre line of a weave; for a
/// whipping torch the speed is that of the strokes' centres; a direction holds from the strike and from the turn on.
/// Places more than 20 mm beyond the seam's ends are left out. Takes time in proportion to the number of steps.
std::vector<SeamMillimetre> alongSeam(const Technique& technique);

/// Stretch of the seam (m) that the arc passed, and the place where it was last. Flashes shorter than kStrikeSeconds do
/// not count. Empty if no arc lasted.
struct WeldedRange {
    FaceStretch stretch;
    double stop = 0;
};
std::optional<WeldedRange> weldedRange(const Technique& technique);

/// Centres (m), in ascending order, of the whole millimetres with the arc burning and the hand unknown: those that it
/// may have passed while tracking was lost or samples were missing. alongSeam() has values for none of them, and omits
/// those where no torch was seen.
std::vector<double> unknownPlaces(const Technique& technique);

/// The columns and rows of technique.csv: one row a millimetre, an empty cell for an unknown value.
std::string techniqueCsv(std::span<const SeamMillimetre> seam, DistanceKind distance);

/// Throws as writeFile() does.
void writeTechniqueCsv(const std::filesystem::path& file, std::span<const SeamMillimetre> seam, DistanceKind distance);

} // namespace meltpool
