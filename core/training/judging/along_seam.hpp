// Technique by the millimetre of the seam: what is drawn, scored and written to technique.csv.
#pragma once

#include "core/training/judging/technique.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

/// s that the arc must burn on end to count as struck; shorter flashes before are not judged.
inline constexpr double kStrikeSeconds = 0.5;
/// m after the strike that are not judged, with at least the first kStrikeSeconds: the pool is set up there.
inline constexpr double kStrikeLength = 3e-3;
/// m before the arc's last end that are not judged: the crater is filled there.
inline constexpr double kCraterLength = 3e-3;

/// A whole millimetre of the seam on which the arc burned.
struct SeamMillimetre {
    double place = 0;       ///< m, its middle
    double seconds = 0;     ///< that the arc burned on it
    bool judged = false;    ///< lies neither in the strike nor in the crater, and the hand is known on it
    bool known = true;      ///< what the hand did there; else the values are unknown
    int direction = 0;      ///< of travel: +1 towards growing places, -1, 0 unknown
    double current = 0;     ///< A of the arc, mean over the time there
    double voltage = 0;     ///< V, the same
    TechniqueValues values; ///< means over the time there; that of judged steps where there are some
};

/// The attempt so far, in ascending places; millimetres without arc are missing. Unlike Technique::now() this looks at
/// what comes after each step too: the speed's window is centred on it, within its stretch of arc (which ends where the
/// arc goes out, tracking is lost, samples are missing or the torch jumps); aim is the centre line of a weave; where
/// the torch whips, the speed is that of the strokes' middles; a direction holds from the strike and from the turn on.
/// Places more than 20 mm beyond the seam's ends are left out. Takes time in proportion to the number of steps.
std::vector<SeamMillimetre> alongSeam(const Technique& technique);

/// Middles (m), in ascending order, of the whole millimetres on which the hand is not known though the arc burned:
/// those that it may have passed while tracking was lost or samples were missing. alongSeam() has values for none of
/// them, and misses those where no torch was seen.
std::vector<double> unknownPlaces(const Technique& technique);

/// The columns and rows of technique.csv: one row a millimetre, an empty cell for what is unknown.
std::string techniqueCsv(std::span<const SeamMillimetre> seam, DistanceKind distance);

/// Throws what writeFile() throws.
void writeTechniqueCsv(const std::filesystem::path& file, std::span<const SeamMillimetre> seam, DistanceKind distance);

} // namespace meltpool
