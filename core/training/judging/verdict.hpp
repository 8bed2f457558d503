// The verdict on a measured weld by the limits of an acceptance file.
#pragma once

#include "core/training/judging/acceptance.hpp"
#include "core/training/judging/estimates.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <array>

namespace meltpool {

enum class VerdictState { pass, fail, notResolved, estimated };

/// What files call the states, in their order.
inline constexpr std::array<std::string_view, 4> kVerdictStates{"pass", "fail", "not_resolved", "estimated"};
constexpr std::string_view nameOf(VerdictState state) {
    return kVerdictStates[static_cast<size_t>(state)];
}

/// One imperfection by one limit, at the place of the weld where it is worst.
struct VerdictItem {
    std::string name; ///< a key of imperfections()
    /// In `unit`; at least 0 of what is too much or missing. Of an estimate see Estimate::value. None where neither the
    /// metal nor an estimate tells it.
    std::optional<double> value;
    /// In `unit`; 0 of what is not permitted; none where the standard has none, and of an estimate: a limit is of an
    /// imperfection's size, which no technique tells.
    std::optional<double> limit;
    LimitKind kind = LimitKind::atMost;
    std::string_view unit; ///< "mm" or "deg"
    VerdictState state = VerdictState::notResolved;
    bool beyond = false;         ///< the value is beyond the limit; of an estimate: the imperfection is to be expected
    double resolution = 0;       ///< in `unit`: what the particles resolve of it
    std::optional<double> place; ///< m along the seam of that worst station
    std::string rule = {};       ///< of an estimate, see Estimate::rule
    /// Where stations are beyond the limit that is not of short ones, each a pitch long, neighbours together, m along
    /// the seam; of an item that fails.
    std::vector<FaceStretch> failing = {};
};

struct Verdict {
    std::string standard, edition, level;
    std::vector<VerdictItem> items; ///< each imperfection once, in the file's order; estimates without a limit last
    /// Something was welded and no item fails. Items that are not resolved or estimated do not decide.
    bool accepted = false;
};

/// Judges a weld by one item. `imperfection`: the row that the item names. Nothing where the item does not hold for
/// this weld. Estimates are left out.
std::optional<VerdictItem> judgeItem(const WeldMeasures& measures, const AcceptanceItem& item,
                                     const WeldFigure& imperfection, const NominalWeld& nominal);

/// Judges every station by every item that applies. With `r` = what the particles resolve of the imperfection, a
/// station
/// - fails beyond the limit, or, where the limit itself is less than r, beyond limit + r;
/// - is not resolved where the limit is less than r and the value not at least r on its safe side; an angle also where
///   it is nearer than r to its limit;
/// - passes otherwise.
/// An item fails where a station does, unless the item allows short ones: then where a station fails the limit of short
/// ones too, or where the stations beyond the limit are longer together than allowed. What needs a nominal size that is
/// not given, and what neither the stations nor an estimate tell, is not resolved.
/// An imperfection of the whole weld (WeldFigure::judgedWhole) is judged as one station at its own place.
Verdict judge(const WeldMeasures& measures, const Acceptance& acceptance, const NominalWeld& nominal,
              std::span<const Estimate> estimates = {});

} // namespace meltpool
