// Judges a measured weld by the limits of an acceptance file.
#pragma once

#include "core/training/judging/acceptance.hpp"
#include "core/training/judging/decision.hpp"
#include "core/training/judging/estimates.hpp"
#include "core/weld/gauge/weld_figures.hpp"

namespace meltpool {

/// One imperfection by one limit, where it decides: at its worst place, or as the mean over a length of the weld.
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
    double uncertainty = 0;      ///< of the value, in `unit`
    std::optional<double> place; ///< m along the seam: that station, or the middle of that length
    std::string rule = {};       ///< rule of an estimate, see Estimate::rule
    /// For an item that fails: stretches of the stations that fail alone, or of those beyond the main limit in a length
    /// that fails by its mean; each station a pitch long, neighbours together, m along the seam.
    std::vector<FaceStretch> failing = {};
    double meanOver = 0; ///< m of seam that the value is the mean of; 0: a single station
};

struct Verdict {
    std::string standard, edition, level;
    std::vector<VerdictItem> items; ///< each imperfection once, in the file's order; estimates without a limit last
    /// True if there is a weld as long as asked for, and no item fails. Items that are not resolved or estimated do not
    /// decide.
    bool accepted = false;
    double judgedLength = 0; ///< m of seam that the items are of
    double askedLength = 0;  ///< m of seam that were to be welded; 0: not said
    bool complete = true;    ///< WeldMeasures::isComplete()

    /// Number of items that are not resolved or estimated: "accepted" says nothing about them.
    size_t notAssessed() const;
};

/// Judges a weld by one item. `imperfection`: the item's row. Empty if the item does not apply to this weld. Estimates
/// are left out.
std::optional<VerdictItem> judgeItem(const WeldMeasures& measures, const AcceptanceItem& item,
                                     const WeldFigure& imperfection, const NominalWeld& nominal);

/// Judges every item that applies by one rule, decide(): the excess over the limit against its uncertainty.
///
/// A figure of one station is uncertain by WeldFigure::resolution: a particle for a length. The mean over neighbouring
/// stations is finer, see ReadingUncertainty. Each side of a weld is judged alone, and the worse one is the item's.
///
/// - An item fails if any run of neighbouring stations fails by its mean: one station alone, all of them, or any run
///   between. With an allowance for short ones the limit of a run is the greatest mean that the allowance leaves it:
///   the limit of short ones over the allowed length, the main limit over the rest. Such an item also fails if the
///   stations that fail the main limit alone are longer together than allowed.
/// - An item passes if every station passes alone; with an allowance also if those that do not are no longer together
///   than allowed, and pass the limit of short ones. A size (WeldFigure::meanDecides) passes if its mean over the whole
///   weld does.
/// - Otherwise it is not resolved; so is an item without a value, and one whose limit needs a size that is not given.
///
/// An imperfection of the whole weld (WeldFigure::judgedWhole) is judged as one station at its own place.
Verdict judge(const WeldMeasures& measures, const Acceptance& acceptance, const NominalWeld& nominal,
              std::span<const Estimate> estimates = {});

} // namespace meltpool
