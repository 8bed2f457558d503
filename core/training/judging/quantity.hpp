// Defines the quantities of a welder's technique: their names in lessons and records, and their units.
#pragma once

#include "core/weld/process/process_traits.hpp"

#include <array>
#include <bitset>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace meltpool {

/// See the handbook's page on technique for definitions and signs.
enum class TechniqueQuantity {
    aim,       ///< offset across the seam of the torch's axis at the seam's height; when weaving, of the weave's
               ///< centre line; positive on SeamFrame::across, the welder's side
    height,    ///< height of the torch's tip above the seam, along the bisector
    distance,  ///< distance, see DistanceKind
    workAngle, ///< angle of the torch from the bisector in the plane across the seam; positive: the handle leans to the
               ///< welder
    travelAngle,    ///< angle of the torch from that plane, in the plane of torch and seam; positive pushes, negative
                    ///< drags
    travelSpeed,    ///< speed of the arc along the seam, in the sensed direction of travel
    weaveWidth,     ///< width from toe to toe; 0 without a weave
    weaveFrequency, ///< whole swings a second; 0 without a weave
    weaveDwell,     ///< dwell at each toe, beyond the time of a swing of even speed there
    whipLength,     ///< stroke along the seam, the mean of both ways; 0 without whipping
    whipPeriod,     ///< time from one stroke to the next
    whipDwell,      ///< dwell in the pool, at the rear end
    rodAngle, ///< angle of the filler rod above the plane across the bisector; 0 is flat on a plate, 90 degrees upright
              ///< on it
    rodFrequency, ///< dips of the rod towards the pool a second; 0 for a rod held still
};
inline constexpr size_t kTechniqueQuantities = 14;

/// A set of quantities of technique, such as those that the desk's torch holds by itself.
using QuantitySet = std::bitset<kTechniqueQuantities>;

/// One value of each quantity in SI units: m, rad, m/s, Hz, s. NaN is unknown, the initial value.
class TechniqueValues {
  public:
    TechniqueValues() { values_.fill(std::numeric_limits<double>::quiet_NaN()); }
    double& operator[](TechniqueQuantity quantity) { return values_[static_cast<size_t>(quantity)]; }
    double operator[](TechniqueQuantity quantity) const { return values_[static_cast<size_t>(quantity)]; }

  private:
    std::array<double, kTechniqueQuantities> values_;
};

struct QuantityInfo {
    TechniqueQuantity quantity;
    std::string_view key;      ///< key in lessons and results, such as "travel_speed"; "" if lessons do not judge it
    std::string_view column;   ///< column of technique.csv, with its unit
    std::string_view wordsKey; ///< key of words()
    std::string_view unit;     ///< unit in lessons and sentences: "mm", "mm/s", "°", "Hz", "s"
    double perSi = 1;          ///< value in `unit` per value in SI
    double least = 0;          ///< range that a lesson may ask for, in `unit`
    double most = 0;

    /// Name in sentences, such as "travel speed". Valid for the whole run.
    std::string_view words() const;
};

/// `distance` decides between `ctwd` and `arc_length`.
const QuantityInfo& quantityInfo(TechniqueQuantity quantity, DistanceKind distance);

/// All quantities of a process, in the order of TechniqueQuantity.
const std::array<QuantityInfo, kTechniqueQuantities>& quantities(DistanceKind distance);

/// Keys of the set's quantities with a blank between them, in the order of TechniqueQuantity: "aim travel_speed".
std::string keysOf(const QuantitySet& set, DistanceKind distance);
/// Names in sentences of the quantities with these keys, as a list: "aim, travel speed". Unknown keys stay as they are.
std::string wordsOfKeys(std::string_view keys);

} // namespace meltpool
