// Judges a measured weld by the limits of an acceptance file.
#pragma once

#include "core/training/judging/acceptance.hpp"
#include "core/training/judging/estimates.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <array>

namespace meltpool {

enum class VerdictState { pass, fail, notResolved, estimated };

/// Names of the states in files, in the order of VerdictState.
inline constexpr std::array<std::string_view, 4> kVerdictStates{"pass", "fail", "not_resolved", "estimated"};
constexpr std::string_view nameOf(VerdictState state) {
    return kVerdictStates[static_cast<size_t>(state)];
}

/// One imperfection by one limit, at its worst place of the weld.
struct VerdictItem {
    std::string name; ///< a key of imperfections()
    /// Value in `unit`; at least 0 for an excess or a lack. For an estimate see Estimate::value. Empty if neither the
    /// metal nor an estimate gives it.
    std::optional<double> value;
    /// Limit in `unit`; 0 means not permitted; empty if the standard has none, and for an estimate: a limit is of an
    /// imperfection's size, which technique does not show.
    std::optional<double> limit;
    LimitKind kind = LimitKind::atMost;
    std::string_view unit; ///< "mm" or "deg"
    VerdictState state = VerdictState::notResolved;
    bool beyond = false;         ///< the value is beyond the limit; for an estimate: the imperfection is to be expected
    double resolution = 0;       ///< resolution of the particles, in `unit`
    std::optional<double> place; ///< m along the seam of that worst station
    std::string rule = {};       ///< rule of an estimate, see Estimate::rule
    /// Stretches of stations beyond the main limit, each station a pitch long, neighbours together, m along the seam;
    /// for an item that fails.
    std::vector<FaceStretch> failing = {};
};

struct Verdict {
    std::string standard, edition, level;
    std::vector<VerdictItem> items; ///< each imperfection once, in the file's order; estimates without a limit last
    /// True if there is a weld and no item fails. Items that are not resolved or estimated do not decide.
    bool accepted = false;
};

/// Judges a weld by one item. `imperfection`: the item's row. Empty if the item does not apply to this weld. Estimates
/// are left out.
std::optional<VerdictItem> judgeItem(const WeldMeasures& measures, const AcceptanceItem& item,
                                     const WeldFigure& imperfection, const NominalWeld& nominal);

/// Judges every station by every item that applies. With `r` = resolution of the imperfection by the particles, a
/// station
/// - fails beyond the limit, or, if the limit itself is less than r, beyond limit + r;
/// - is not resolved if the limit is less than r and the value not at least r on its safe side; an angle also if it is
///   nearer than r to its limit;
/// - passes otherwise.
/// An item fails if a station does, unless the item allows short ones: then if a station fails the limit of short ones
/// too, or if the stations beyond the limit are longer together than allowed. A limit that needs a nominal size that is
/// not given, and an imperfection without a value from stations or an estimate, are not resolved.
/// An imperfection of the whole weld (WeldFigure::judgedWhole) is judged as one station at its own place.
Verdict judge(const WeldMeasures& measures, const Acceptance& acceptance, const NominalWeld& nominal,
              std::span<const Estimate> estimates = {});

} // namespace meltpool
