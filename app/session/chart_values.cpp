#include "app/session/chart_values.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kInMm = 1e3, kMetresPerMinute = 60;

struct LoadedCharts {
    std::vector<ChartRow> rows;
    std::string fault; ///< empty if they could be read
};

const LoadedCharts& loadedCharts() {
    static const LoadedCharts loaded = [] {
        LoadedCharts charts;
        try {
            charts.rows = readCharts(chartFolder());
        } catch (const InputError& fault) {
            charts.fault = fault.what();
        }
        return charts;
    }();
    return loaded;
}

std::string numberText(double value, int digits) {
    const double scale = std::pow(10, digits);
    return withDecimalMark(formatNumber(std::round(value * scale) / scale));
}

/// Returns "3 to 4", or "3" where both ends read the same.
std::string rangeText(const ChartRange& range, double scale, int digits) {
    const std::string least = numberText(range.least * scale, digits), most = numberText(range.most * scale, digits);
    return least == most ? least : phrase("chart.range", {{"least", least}, {"most", most}});
}

/// Returns the chosen language's word for a choice of a parameter.
std::string choiceText(std::string_view key, std::string_view name) {
    return std::string(phraseOr("parameter." + std::string(key) + ".choice." + std::string(name), name));
}

std::string listText(const std::vector<std::string>& names, std::string_view key) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : phrase("list.separator")) + choiceText(key, name);
    return text;
}

std::string titleOf(const ChartRow& row) {
    const std::string joints = listText(row.joints, "workpiece");
    if (!row.thickness)
        return row.joints.empty() ? phrase("chart.row.any") : phrase("chart.row.joints", {{"joints", joints}});
    const std::string thickness = rangeText(*row.thickness, kInMm, 1);
    if (row.joints.empty()) return phrase("chart.row.thickness", {{"thickness", thickness}});
    return phrase("chart.row.both", {{"joints", joints}, {"thickness", thickness}});
}

/// Adds a figure of the row, its middle first.
void addFigure(ShownChartRow& shown, std::string_view name, const std::optional<ChartRange>& range, double scale,
               int digits, std::string_view unit) {
    if (!range) return;
    const std::string middle = numberText(range->middle() * scale, digits);
    const std::string all = rangeText(*range, scale, digits);
    shown.figures.push_back(
        {phraseOf("chart.label", name),
         all == middle ? phrase("chart.value", {{"middle", middle}, {"unit", unit}})
                       : phrase("chart.value_of_range", {{"middle", middle}, {"range", all}, {"unit", unit}})});
}

ShownChartRow shownRow(const StartingValues& values) {
    const ChartRow& row = *values.row;
    ShownChartRow shown{values, capitalised(titleOf(row)), {}, {}, {}};
    if (!row.transfer.empty())
        shown.figures.push_back({phrase("chart.label.transfer"), phraseOf("chart.transfer", row.transfer)});
    addFigure(shown, "voltage", values.voltage, 1, 1, "V");
    addFigure(shown, "feed", values.feed, kMetresPerMinute, 1, "m/min");
    addFigure(shown, "current", values.current, 1, 0, "A");
    addFigure(shown, "speed", row.speed, kInMm, 1, "mm/s");
    addFigure(shown, "tip_distance", row.tipDistance, kInMm, 0, "mm");
    addFigure(shown, "gap", row.gap, kInMm, 1, "mm");
    addFigure(shown, "leg", row.leg, kInMm, 1, "mm");
    addFigure(shown, "rod", row.rod, kInMm, 1, "mm");
    shown.source =
        row.note.empty() ? row.source : phrase("chart.source_with_note", {{"source", row.source}, {"note", row.note}});
    if (!row.read) shown.notes.push_back(phrase("chart.note.memory"));
    if (values.gasVoltage != 0)
        shown.notes.push_back(
            phrase(values.gasVoltage > 0 ? "chart.note.gas_more" : "chart.note.gas_less",
                   {{"gas", gasText(*row.gases.front())}, {"volts", numberText(std::abs(values.gasVoltage), 1)}}));
    if (values.feedFromCurrent) shown.notes.push_back(phrase("chart.note.feed"));
    return shown;
}

/// Returns the sentence about plates and tools that no row is for.
std::string noRow(const Lesson& lesson) {
    const Equipment tools = equipmentOf(lesson.process);
    const std::string joint = choiceText("workpiece", workpieceNames()[static_cast<size_t>(lesson.workpiece.kind)]);
    const std::string thickness = numberText(static_cast<double>(lesson.workpiece.thicknessMm), 1);
    const std::string diameter = numberText(std::max(tools.wire, tools.electrode) * kInMm, 1);
    const std::string_view gas = tools.gas == nullptr ? std::string_view() : gasText(*tools.gas);
    const std::string_view kind = tools.wire > 0        ? "chart.none.wire"
                                  : tools.electrode > 0 ? "chart.none.electrode"
                                                        : "chart.none.tungsten";
    return phrase(kind, {{"joint", joint},
                         {"position", chartPosition(lesson.workpiece)},
                         {"thickness", thickness},
                         {"metal", lesson.workpiece.metal},
                         {"diameter", diameter},
                         {"electrode", tools.electrodeName},
                         {"gas", gas}});
}

/// Returns the tip-to-work distance that the lesson asks for, at which the wire carries its current; m.
std::optional<double> askedTipDistance(const Lesson& lesson) {
    if (!lesson.technique || lesson.technique->distance != DistanceKind::ctwd) return std::nullopt;
    const TechniqueBand* band = lesson.technique->find(TechniqueQuantity::distance);
    return band == nullptr ? std::nullopt : std::optional(band->ideal / kInMm);
}

} // namespace

bool ChartValues::applies() const {
    return lesson_.model == LessonModel::Weld && isArcWelding(lesson_.process);
}

ChartValues::Asked ChartValues::asked() const {
    const Equipment tools = equipmentOf(lesson_.process);
    return {lesson_.workpiece.kind,
            lesson_.workpiece.position,
            lesson_.process.kind,
            lesson_.workpiece.thicknessMm,
            tools.wire,
            tools.electrode,
            tools.heldBehind,
            tools.electrodeName,
            tools.gas,
            chosenUnits()};
}

void ChartValues::update() {
    if (!applies()) return;
    const Asked now = asked();
    if (now == asked_ && metal_ == lesson_.workpiece.metal) return;
    asked_ = now;
    metal_ = lesson_.workpiece.metal;
    rows_.clear();
    shown_ = 0;
    const LoadedCharts& charts = loadedCharts();
    for (const StartingValues& values :
         fittingStartingValues(charts.rows, lesson_.workpiece, lesson_.process, askedTipDistance(lesson_)))
        rows_.push_back(shownRow(values));
    notice_ = !charts.fault.empty() ? charts.fault : rows_.empty() ? noRow(lesson_) : std::string();
}

std::array<ChartValues::Setting, 3> ChartValues::settings() const {
    std::array<Setting, 3> found{};
    if (rows_.empty()) return found;
    const StartingValues& values = shown().values;
    const auto set = [&](size_t place, std::string_view key, const std::optional<ChartRange>& range, double scale,
                         double grain) {
        const Parameter* parameter = findParameter(machine_.parameters, key);
        if (!range || parameter == nullptr || machine_.isGiven(*parameter)) return;
        found[place] = {parameter, std::round(range->middle() * scale / grain) * grain};
    };
    set(0, "voltage", values.voltage, 1, 0.1);
    set(1, "wire_feed_m_min", values.feed, kMetresPerMinute, 0.1);
    set(2, "current", values.current, 1, 1);
    return found;
}

bool ChartValues::canTake() const {
    const auto all = settings();
    return std::any_of(all.begin(), all.end(), [](const Setting& each) { return each.parameter != nullptr; });
}

bool ChartValues::beyondLimits() const {
    const auto all = settings();
    return std::any_of(all.begin(), all.end(), [](const Setting& each) {
        return each.parameter != nullptr &&
               (each.value < each.parameter->minimum || each.value > each.parameter->maximum);
    });
}

void ChartValues::take() {
    for (const Setting& each : settings()) {
        if (each.parameter == nullptr) continue;
        const auto value = static_cast<float>(std::clamp(each.value, each.parameter->minimum, each.parameter->maximum));
        setParameter({*each.parameter}, each.parameter->key, formatNumber(value), "chart");
    }
}

} // namespace meltpool
