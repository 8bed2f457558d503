// Holds a lesson's technique windows: the ideal of each quantity and the cost of each deviation.
#pragma once

#include "core/training/judging/technique.hpp"

#include <vector>

namespace meltpool {

class TomlTable;

/// Zone of a value in a band.
enum class BandZone {
    inside,  ///< within the inner half width: full points
    between, ///< some points
    beyond,  ///< no points, from the outer half width on
};

/// Window of one parameter, in the unit of QuantityInfo: mm, mm/s, degrees, Hz, s.
struct TechniqueBand {
    TechniqueQuantity quantity = TechniqueQuantity::aim;
    double ideal = 0;
    double inner = 0;  ///< half width of full points, 100
    double outer = 0;  ///< half width from which points are 0; at least `inner`
    double weight = 1; ///< weight in the whole score, at least 0

    /// Points 0..100 of a value in this band's unit: 100 to `inner`, then falling linearly to 0 at `outer`. An unknown
    /// value has 0.
    double points(double value) const;
    BandZone zone(double value) const;
    /// True beyond the inner half width, in the digits that a reader sees too (one behind the point): 7.14 with a
    /// target of 6.5 ± 0.6 reads as 7.1, which is allowed.
    bool readsBeyond(double value) const;
};

/// Direction along the seam that a lesson asks for.
enum class TravelDirection { either, forward, backward };

struct TechniqueBands {
    DistanceKind distance = DistanceKind::ctwd;
    double lengthFromMm = 0; ///< wanted seam; places are in whole millimetres
    double lengthToMm = 0;
    TravelDirection direction = TravelDirection::either; ///< forward: towards growing places
    double speedWindow = 0.5;                            ///< s, see TechniqueSettings
    bool tee = false;                                    ///< the seam is between a base plate and an upright plate
    std::vector<TechniqueBand> bands;                    ///< bands of the judged parameters, each once

    /// Null for a quantity that is not judged.
    const TechniqueBand* find(TechniqueQuantity quantity) const;
    /// The judged value of a quantity, in its band's unit: its speed counts negative if the torch travels (`sensed`:
    /// +1, -1, or 0 while unknown) against the demanded direction.
    double judged(const TechniqueValues& values, int sensed, TechniqueQuantity quantity) const;
    TechniqueSettings settings() const { return {distance, speedWindow}; }
};

/// Reads a lesson's table [technique]:
///
///     [technique]
///     length_from_mm = -40          # of the wanted seam; required
///     length_to_mm = 40
///     direction = "forward"         # or "backward", "either" (the default)
///     speed_window_s = 0.5          # 0.1 to 10
///     travel_speed = { ideal = 5.5, inner = 0.8, outer = 2.5, weight = 2 }   # weight is 1 unless said
///
/// The keys of bands are those of quantities(distance). Throws InputError with file, line and key for an unknown key, a
/// missing or impossible value, a length that is not on `seam`, and a table without a band of some weight.
TechniqueBands readTechniqueBands(TomlTable& table, DistanceKind distance, const Seam& seam);

} // namespace meltpool
