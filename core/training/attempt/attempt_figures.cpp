#include "core/training/attempt/attempt_figures.hpp"

#include <array>
#include <cmath>

namespace meltpool {

namespace {

/// Times half a spacing that an area differs by at least, in mm: the length of outline over which layers of particles
/// are one more or one less.
constexpr double kOutlineMm = 8;

struct Row {
    std::string_view key, name, unit, more, less;
    double halfSpacings, least, much;
    bool onlyOver;
};

/// Of the weld. What differs by `much` weighs alike: chosen here as what an inspector would call another weld.
constexpr std::array kWeldRows{
    Row{"penetration_mm", "penetration", "mm", "more penetration", "less penetration", 1, 0, 0.5, false},
    Row{"toe_width_mm", "width", "mm", "wider", "narrower", 1, 0, 1, false},
    Row{"height_mm", "reinforcement", "mm", "higher", "lower", 1, 0, 0.5, false},
    Row{"leg1_mm", "leg on the lying plate", "mm", "more leg on the lying plate", "less leg on the lying plate", 1, 0,
        1, false},
    Row{"leg2_mm", "leg on the standing plate", "mm", "more leg on the standing plate",
        "less leg on the standing plate", 1, 0, 1, false},
    Row{"throat_mm", "throat", "mm", "more throat", "less throat", 1, 0, 0.5, false},
    Row{"convexity_mm", "convexity", "mm", "more convex", "less convex", 1, 0, 0.5, false},
    Row{"root_fusion_mm", "root fusion", "mm", "more root fusion", "less root fusion", 1, 0, 0.5, false},
    Row{"root_fused_percent", "fused root", "%", "more of the root fused", "less of the root fused", 0, 5, 20, false},
    Row{"lack_of_fusion_mm", "lack of fusion", "mm", "more lack of fusion", "less lack of fusion", 1, 0, 0.5, true},
    Row{"root_missing_mm", "missing root", "mm", "more of the root missing", "less of the root missing", 1, 0, 0.5,
        true},
    Row{"overlap_1_mm", "overlap on side 1", "mm", "more overlap on side 1", "less overlap on side 1", 1, 0, 0.5, true},
    Row{"overlap_2_mm", "overlap on side 2", "mm", "more overlap on side 2", "less overlap on side 2", 1, 0, 0.5, true},
    Row{"undercut_1_mm", "undercut on side 1", "mm", "more undercut on side 1", "less undercut on side 1", 1, 0, 0.3,
        true},
    Row{"undercut_2_mm", "undercut on side 2", "mm", "more undercut on side 2", "less undercut on side 2", 1, 0, 0.3,
        true},
    Row{"underfill_mm", "underfill", "mm", "more underfill", "less underfill", 1, 0, 0.5, true},
    Row{"excess_penetration_mm", "excess penetration", "mm", "more excess penetration", "less excess penetration", 1, 0,
        0.5, true},
    Row{"root_concavity_mm", "root concavity", "mm", "more root concavity", "less root concavity", 1, 0, 0.5, true},
    Row{"hole_mm", "burn-through", "mm", "more burn-through", "less burn-through", 1, 0, 0.5, true},
    Row{"deposited_mm2", "deposited metal", "mm2", "more deposited metal", "less deposited metal", kOutlineMm, 0, 8,
        false},
    Row{"haz_width_mm", "heat-affected zone", "mm", "more heat-affected zone", "less heat-affected zone", 1, 0, 1,
        false},
    Row{"t85_s", "cooling time t8/5", "s", "longer cooling (t8/5)", "shorter cooling (t8/5)", 0, 0.5, 3, false},
};

constexpr std::array kArcRows{
    Row{"heat_input_kj_mm", "heat input", "kJ/mm", "more heat input", "less heat input", 0, 0.02, 0.2, false},
    Row{"mean_current_a", "mean current", "A", "more current", "less current", 0, 1, 30, false},
    Row{"mean_voltage_v", "mean voltage", "V", "more voltage", "less voltage", 0, 0.2, 3, false},
    Row{"seconds", "time of the arc", "s", "longer arc time", "shorter arc time", 0, 0.2, 10, false},
};

ComparedFigure figureOf(const Row& row, FigureGroup group) {
    ComparedFigure figure;
    figure.key = row.key;
    figure.name = row.name;
    figure.unit = row.unit;
    figure.more = row.more;
    figure.less = row.less;
    figure.group = group;
    figure.halfSpacings = row.halfSpacings;
    figure.least = row.least;
    figure.much = row.much;
    figure.onlyOver = row.onlyOver;
    if (row.unit == "%" || row.unit == "A") figure.decimals = 0;
    if (row.unit == "kJ/mm") figure.decimals = 2;
    return figure;
}

/// What of a hand is told as another way of leading the torch, and how much is as much as that of another quantity.
struct HandScale {
    std::string_view unit;
    double least, much;
    int decimals;
};
constexpr std::array<HandScale, 5> kHandScales{
    {{"mm", 0.2, 2, 1}, {"mm/s", 0.2, 2, 1}, {"°", 1, 10, 0}, {"Hz", 0.2, 1, 1}, {"s", 0.1, 1, 1}}};

ComparedFigure figureOf(const QuantityInfo& info) {
    ComparedFigure figure;
    figure.key = info.key;
    figure.name = info.words;
    figure.unit = info.unit;
    figure.more = "more " + figure.name;
    figure.less = "less " + figure.name;
    if (info.quantity == TechniqueQuantity::travelSpeed) {
        figure.more = "faster travel";
        figure.less = "slower travel";
    }
    figure.group = FigureGroup::hand;
    for (const HandScale& scale : kHandScales)
        if (scale.unit == info.unit) {
            figure.least = scale.least;
            figure.much = scale.much;
            figure.decimals = scale.decimals;
        }
    return figure;
}

/// Mean of a quantity over the judged millimetres, in its unit; NaN where none knows it.
double meanOf(std::span<const SeamMillimetre> seam, const QuantityInfo& info) {
    double sum = 0;
    int count = 0;
    for (const SeamMillimetre& each : seam) {
        const double value = each.values[info.quantity] * info.perSi;
        if (!each.judged || !std::isfinite(value)) continue;
        sum += value;
        ++count;
    }
    return count > 0 ? sum / count : std::nan("");
}

void addArc(AttemptFigures& figures, const Judgement& judgement, const ProcessSettings& process) {
    const ArcAccount& arc = judgement.arc;
    if (!(arc.seconds > 0)) return;
    figures.values["seconds"] = arc.seconds;
    figures.values["mean_current_a"] = arc.meanCurrent();
    figures.values["mean_voltage_v"] = arc.meanVoltage();
    const double length = static_cast<double>(judgement.seam.size()) * 1e-3; // as result.json has it
    if (const auto efficiency = standardEfficiency(process); efficiency && length > 0)
        figures.values["heat_input_kj_mm"] = arc.heatInput(*efficiency, length) * 1e-6;
}

} // namespace

std::vector<ComparedFigure> comparedFigures(DistanceKind distance) {
    std::vector<ComparedFigure> all;
    for (const Row& row : kWeldRows)
        all.push_back(figureOf(row, FigureGroup::weld));
    for (const QuantityInfo& info : quantities(distance))
        if (!info.key.empty()) all.push_back(figureOf(info));
    for (const Row& row : kArcRows)
        all.push_back(figureOf(row, FigureGroup::arc));
    return all;
}

AttemptFigures figuresOf(const Judgement& judgement, const ProcessSettings& process) {
    AttemptFigures figures;
    figures.distance = judgement.distance;
    if (judgement.weld) {
        figures.spacing = judgement.weld->spacing;
        for (const StationColumn& column : stationColumns())
            if (const auto& value = judgement.weld->mean.*column.value)
                figures.values[std::string(column.name)] = *value / column.unit;
    }
    for (const QuantityInfo& info : quantities(judgement.distance))
        if (const double mean = meanOf(judgement.seam, info); !info.key.empty() && std::isfinite(mean))
            figures.values[std::string(info.key)] = mean;
    addArc(figures, judgement, process);
    if (judgement.score && judgement.score->scored) {
        figures.score = judgement.score->total;
        for (const ParameterScore& each : judgement.score->parameters)
            figures.points[std::string(quantityInfo(each.quantity, judgement.distance).key)] = each.score;
    }
    return figures;
}

} // namespace meltpool
