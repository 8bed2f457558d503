// Keys of the [case] table of every kind that welds.
#pragma once

#include "core/validation/validation_case.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace meltpool::weld_case {

using enum CaseValue;

inline constexpr auto kNeeded = std::nullopt;
inline constexpr double kHot = kHottest;
inline constexpr double kRoom = 293.15; ///< K

/// Joins two lists of keys to one, for the compiler.
template <size_t M, size_t N>
constexpr std::array<CaseKey, M + N> joined(const std::array<CaseKey, M>& first, const std::array<CaseKey, N>& second) {
    return [&]<size_t... I, size_t... J>(std::index_sequence<I...>, std::index_sequence<J...>) {
        return std::array<CaseKey, M + N>{first[I]..., second[J]...};
    }
    (std::make_index_sequence<M>(), std::make_index_sequence<N>());
}

/// Keys of the process of every weld, see caseProcess().
inline constexpr std::array kArc{
    CaseKey{"process", process, 0, 0, 0.0, "gmaw with wire, gtaw without; smaw in a chart's weld"},
    CaseKey{"power_w", number, 0, 1e6, 0.0, "electric, where voltage and current are not given"},
    CaseKey{"voltage", number, 0, 60, 0.0, "of the welding machine, with wire"},
    CaseKey{"current_a", number, 0, 2000, 0.0, "of an arc without wire; with wire the feed follows from it"},
    CaseKey{"wire_diameter_mm", number, 0, 10, 0.0, "0: no wire, a tungsten electrode"},
    CaseKey{"wire_feed_m_min", number, 0, 100, 0.0, "of the wire"},
    CaseKey{"gas", word, 0, 0, 0.0, "shielding gas of a wire; the mix of argon and carbon dioxide without it"},
    CaseKey{"short_circuits", word, 0, 0, 0.0,
            "of a wire: ordinary, or controlled by the machine; ordinary without it"},
    CaseKey{"ctwd_mm", number, 1, 60, 15.0, "contact tip to work distance, with wire"},
    CaseKey{"arc_length_mm", number, 0.3, 30, 3.0, "from the tungsten or covered electrode"},
};
/// Keys of every weld on a plate.
inline constexpr std::array kPlate{
    CaseKey{"plate_mm", triple, 0.1, 1000, kNeeded,
            "along the seam first; of the other two the smaller is the thickness"},
    CaseKey{"ambient_k", number, 1, kHot, kNeeded, "plate and air"},
};
inline constexpr CaseKey kTravel{"speed_mm_s", number, 0.01, 1000, kNeeded, "of travel"};
inline constexpr std::array kEnergy = joined(
    std::array{
        CaseKey{"on_s", number, 0, 1e5, kNeeded, "time that the trigger is pulled"},
        CaseKey{"loss", lossRate, 0, 1e6, 0.0, "heat lost from the surface: true, false or W/(m² K)"},
        CaseKey{"speed_mm_s", number, 0, 1000, 0.0, "of travel"},
    },
    kArc);
inline constexpr std::array kBead =
    joined(joined(std::array{kTravel,
                             // Keys of earlier editions: read, and not used, as all welds have one set of constants.
                             CaseKey{"efficiency", number, 0.01, 1, 1.0, "not used: a constant of the process"},
                             CaseKey{"arc_sigma_mm", number, 0.1, 50, 1.0,
                                     "not used: follows from the arc's length and current"},
                             CaseKey{"liquid_conductivity_factor", number, 0.1, 20, 1.0,
                                     "not used: a constant of all arc welds"}},
                  kPlate),
           kArc);
inline constexpr std::array kFillet =
    joined(joined(std::array{kTravel, CaseKey{"standing_mm", number, 1, 1000, 25.0, "height of the upright plate"},
                             CaseKey{"work_angle_deg", number, 5, 85, 45.0, "between torch and base plate"},
                             CaseKey{"travel_angle_deg", number, -60, 60, 0.0, "positive pushes"}},
                  kPlate),
           kArc);
/// Keys of a weld at a chart's values; those that the chart's row has need not be there.
inline constexpr std::array kChart =
    joined(std::array{CaseKey{"row", word, 0, 0, 0.0, "of a chart, by its id"},
                      kTravel,
                      CaseKey{"thickness_mm", number, 0.1, 100, kNeeded, "of each plate"},
                      CaseKey{"gap_mm", number, 0, 10, 0.0, "of a butt joint"},
                      CaseKey{"seam_mm", number, 4, 1000, 20.0, "of weld that counts"},
                      CaseKey{"run_in_mm", number, 2, 1000, 5.0, "of weld at each end that do not count"},
                      CaseKey{"leg_mm", number, 0, 50, 0.0, "intended leg of a fillet; 0: none is asked for"},
                      CaseKey{"travel_angle_deg", number, -60, 60, 15.0, "positive pushes"},
                      CaseKey{"aim_mm", number, -10, 10, 0.0, "of the torch off the seam, on the base plate"},
                      CaseKey{"weave_mm", number, 0, 20, 0.0, "width of a weave; 0: none"},
                      CaseKey{"weave_hz", number, 0, 10, 5.0, "swings of the weave a second"},
                      CaseKey{"voltage_offset_v", number, -30, 30, 0.0, "added to the voltage at a given wire feed"},
                      CaseKey{"speed_factor", number, 0.1, 10, 1.0, "times the travel speed at a given wire feed"},
                      CaseKey{"position", word, 0, 0, 0.0, "of the joint, see lessons"},
                      CaseKey{"electrode", word, 0, 0, 0.0, "covered electrode of smaw: e6013, e7018 or e6010"},
                      CaseKey{"electrode_diameter_mm", number, 0, 10, 0.0, "of its core, or of the tungsten"},
                      CaseKey{"rod_diameter_mm", number, 0, 10, 0.0, "of the filler rod of gtaw; 0: none"},
                      CaseKey{"rod_ahead_mm", number, 0, 20, 1.5, "from the electrode to where the rod dips"},
                      CaseKey{"rod_dips_hz", number, 0, 20, 1.0, "dips of the rod a second"},
                      CaseKey{"rod_feed_mm_s", number, 0, 100, 3.5, "speed at which the fingers feed the rod"},
                      CaseKey{"ambient_k", number, 1, kHot, kRoom, "plate and air"}},
           kArc);
inline constexpr std::array kSpot = joined(
    joined(std::array{CaseKey{"on_s", number, 0.02, 600, kNeeded, "time that the trigger is pulled"}}, kPlate), kArc);
inline constexpr std::array kCooling =
    joined(joined(std::array{kTravel, CaseKey{"hot_k", number, 300, kHot, 1730.15, "start of the rate's interval"},
                             CaseKey{"cold_k", number, 300, kHot, 1539.15, "end of the rate's interval"},
                             CaseKey{"until_k", number, 0, kHot, 0.0, "temperature that ends the case; 0: cold_k"}},
                  kPlate),
           kArc);

inline constexpr std::string_view kChartResults =
    "current_a, voltage_v, arc_length_mm, leg_lying_mm, leg_standing_mm, throat_mm, height_mm, toe_angle_lying_deg, "
    "toe_angle_standing_deg, overlap_lying_mm, overlap_standing_mm, undercut_lying_mm, undercut_standing_mm, "
    "root_fused_percent, root_fusion_mm, root_missing_mm, excess_penetration_mm, hole_mm, penetration_mm, accepted, "
    "spatter_expected, toe_width_mm, fused_width_mm, root_width_mm, "
    "heat_by_drops_percent, arc_caught_percent, arc_on_solid_percent, arc_on_solid_ahead_percent, "
    "arc_on_solid_lying_percent, arc_on_solid_standing_percent, line_warmth_lying_k, line_warmth_standing_k, "
    "refused_filler";

} // namespace meltpool::weld_case
