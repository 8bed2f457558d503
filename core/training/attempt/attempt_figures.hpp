// Lists the figures of an attempt that can be compared with another's: weld, hand, arc and score.
#pragma once

#include "core/training/judging/judgement.hpp"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Subject of a figure.
enum class FigureGroup { weld, hand, arc };

/// A figure of an attempt. The words for a difference of it are in data/words under its key: figure.KEY.more and
/// figure.KEY.less.
struct ComparedFigure {
    std::string key;  ///< column of weld.csv, key of QuantityInfo, or entry of `arc` in result.json
    std::string name; ///< "penetration"
    std::string unit; ///< "mm", "mm2", "mm/s", "°", "%", "Hz", "s", "A", "V", "kJ/mm"
    FigureGroup group = FigureGroup::weld;
    double resolution = 0; ///< resolution of a weld figure, see WeldFigure::resolution
    double least = 0;      ///< least difference that counts, in `unit`
    double much = 1;       ///< difference of equal weight for every figure, in `unit`
    int decimals = 1;      ///< decimals to print
    bool onlyOver = false; ///< negative values mean "no fault" and compare as 0
    bool isSize = false;   ///< main size of a weld, always drawn
};

/// All compared figures of a process with this distance, each key once.
std::vector<ComparedFigure> comparedFigures(DistanceKind distance);

/// Figures of one attempt, from a judgement or from the files of a run.
struct AttemptFigures {
    DistanceKind distance = DistanceKind::ctwd;
    double spacing = 0;                   ///< particle spacing, m; 0: unknown
    std::map<std::string, double> values; ///< values by ComparedFigure::key, in its unit; unknown ones are missing
    std::optional<double> score;          ///< score of the technique, 0..100
    std::map<std::string, double> points; ///< points 0..100 of each judged quantity, by QuantityInfo::key
};

/// Figures of a judged attempt: means over the stations of the weld and over the judged millimetres of the seam.
/// `process`: the lesson's.
AttemptFigures figuresOf(const Judgement& judgement, const ProcessSettings& process);

} // namespace meltpool
