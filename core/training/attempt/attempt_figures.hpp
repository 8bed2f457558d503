// The figures of an attempt that can be held against another's: weld, hand, arc and score.
#pragma once

#include "core/training/judging/judgement.hpp"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// What a figure is told of.
enum class FigureGroup { weld, hand, arc };

/// A figure of an attempt. How a difference of it is told stands under its key in data/words: figure.KEY.more and
/// figure.KEY.less.
struct ComparedFigure {
    std::string key;  ///< a column of weld.csv, a key of QuantityInfo, an entry of `arc` in result.json
    std::string name; ///< "penetration"
    std::string unit; ///< "mm", "mm2", "mm/s", "°", "%", "Hz", "s", "A", "V", "kJ/mm"
    FigureGroup group = FigureGroup::weld;
    double resolution = 0; ///< of a figure of the weld, see WeldFigure::resolution
    double least = 0;      ///< in `unit`: a smaller difference is none
    double much = 1;       ///< in `unit`: differences of so much weigh alike
    int decimals = 1;      ///< that are told
    bool onlyOver = false; ///< values below 0 say how far away the fault is and count as 0
    bool isSize = false;   ///< a size by which every weld is known
};

/// All figures that are compared, of a process with this distance. Each key once.
std::vector<ComparedFigure> comparedFigures(DistanceKind distance);

/// One attempt, from a judgement or from the files that a run has left.
struct AttemptFigures {
    DistanceKind distance = DistanceKind::ctwd;
    double spacing = 0;                   ///< m, of the particles; 0: not known
    std::map<std::string, double> values; ///< by ComparedFigure::key, in its unit; what is not known is missing
    std::optional<double> score;          ///< of the technique, 0..100
    std::map<std::string, double> points; ///< 0..100 of each judged quantity, by QuantityInfo::key
};

/// Of an attempt as it was judged: means over the stations of the weld and over the judged millimetres of the seam.
/// `process`: the lesson's.
AttemptFigures figuresOf(const Judgement& judgement, const ProcessSettings& process);

} // namespace meltpool
