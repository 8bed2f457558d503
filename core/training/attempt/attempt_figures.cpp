#include "core/training/attempt/attempt_figures.hpp"

#include "core/base/words.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <array>
#include <cmath>

namespace meltpool {

namespace {

struct ArcRow {
    std::string_view key, unit;
    double least, much;
    int decimals;
};

constexpr std::array kArcRows{
    ArcRow{"heat_input_kj_mm", "kJ/mm", 0.02, 0.2, 2},
    ArcRow{"mean_current_a", "A", 1, 30, 0},
    ArcRow{"mean_voltage_v", "V", 0.2, 3, 1},
    ArcRow{"seconds", "s", 0.2, 10, 1},
};

ComparedFigure figureOf(const WeldFigure& row) {
    ComparedFigure figure;
    figure.key = row.key;
    figure.name = row.name();
    figure.unit = row.unit;
    figure.group = FigureGroup::weld;
    figure.resolution = row.resolution;
    figure.least = row.scale.least;
    figure.much = row.scale.much;
    figure.decimals = row.digits;
    figure.onlyOver = row.scale.onlyOver;
    figure.isSize = row.scale.isSize;
    return figure;
}

ComparedFigure figureOf(const ArcRow& row) {
    ComparedFigure figure;
    figure.key = row.key;
    figure.name = phraseOf("figure", figure.key + ".name");
    figure.unit = row.unit;
    figure.group = FigureGroup::arc;
    figure.least = row.least;
    figure.much = row.much;
    figure.decimals = row.decimals;
    return figure;
}

/// Reporting scale of a quantity of the hand: the smallest difference that counts, and the difference that weighs as
/// much as one of another quantity.
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
    figure.name = info.words();
    figure.unit = info.unit;
    figure.group = FigureGroup::hand;
    for (const HandScale& scale : kHandScales)
        if (scale.unit == info.unit) {
            figure.least = scale.least;
            figure.much = scale.much;
            figure.decimals = scale.decimals;
        }
    return figure;
}

/// Mean of a quantity over the judged millimetres, in its unit; NaN if no millimetre knows it.
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
    const double length = static_cast<double>(judgement.seam.size()) * 1e-3; // rounded as in result.json
    if (const auto efficiency = traitsOf(process).efficiency; efficiency && length > 0)
        figures.values["heat_input_kj_mm"] = arc.heatInput(*efficiency, length) * 1e-6;
}

} // namespace

std::vector<ComparedFigure> comparedFigures(DistanceKind distance) {
    std::vector<ComparedFigure> all;
    for (const WeldFigure& row : stationFigures())
        if (row.scale.much > 0) all.push_back(figureOf(row));
    for (const QuantityInfo& info : quantities(distance))
        if (!info.key.empty()) all.push_back(figureOf(info));
    for (const ArcRow& row : kArcRows)
        all.push_back(figureOf(row));
    return all;
}

AttemptFigures figuresOf(const Judgement& judgement, const ProcessSettings& process) {
    AttemptFigures figures;
    figures.distance = judgement.distance;
    if (judgement.weld) {
        figures.spacing = judgement.weld->spacing;
        for (const WeldFigure& figure : stationFigures())
            if (const auto& value = judgement.weld->mean.*figure.member)
                figures.values[std::string(figure.key)] = *value / figure.inSi();
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
