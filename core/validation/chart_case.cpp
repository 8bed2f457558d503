#include "core/validation/chart_case.hpp"

#include "core/base/text.hpp"
#include "core/weld/process/machine_chart.hpp"
#include "core/weld/workpiece/position.hpp"

#include <algorithm>

namespace meltpool {

namespace {

constexpr std::string_view kKind = "chart_";

ChartRow findRow(TomlTable& table, const std::string& id) {
    for (ChartRow& row : readCharts(chartFolder()))
        if (row.id == id) return row;
    table.fail("row", "no chart has the row " + quote(id) + "; expected an id of a file in app/data/charts");
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// Throws if the row is not for the joint of the case.
void requireJoint(TomlTable& table, const CaseKind& kind, const ChartRow& row) {
    if (!contains(row.joints, kind.name.substr(kKind.size())))
        table.fail("row", "is for another joint than " + std::string(kind.name));
}

/// Throws if the case's own value of a key is not within the row's range.
void requireWithin(TomlTable& table, const std::string& key, const std::optional<ChartRange>& range, double unit) {
    if (!range || !table.has(key) || range->holds(table.number(key) * unit, kWireSlack)) return;
    table.fail(key, "is not the row's; expected " + formatNumber(range->least / unit) + " to " +
                        formatNumber(range->most / unit));
}

/// Returns the name of the position in which the row's joint is welded; empty: as the joint lies.
std::string positionOf(const ChartRow& row, const CaseKind& kind) {
    WorkpieceParameters lying;
    lying.kind = chartJoint(kind);
    return contains(row.positions, chartPosition(lying)) ? std::string() : row.positions.front();
}

/// Throws for a covered electrode without its kind, core or current.
void checkElectrode(TomlTable& table, const ValidationCase& from) {
    const auto names = smawElectrodes();
    if (std::find(names.begin(), names.end(), from.word("electrode")) == names.end())
        table.fail("electrode", "is " + quote(from.word("electrode")) + "; expected e6013, e7018 or e6010");
    if (from.number("electrode_diameter_mm") <= 0)
        table.fail("electrode_diameter_mm", "is missing; expected the diameter of the core in mm");
    if (from.number("current_a") <= 0)
        table.fail("current_a", "is missing; expected the current of the covered electrode in A");
}

/// Throws for keys of electrode and rod that another process has no use for.
void checkUnused(TomlTable& table, const ValidationCase& from) {
    const auto refuse = [&](const char* key, bool given) {
        if (given) table.fail(key, "is of no use to " + from.process + "; expected it left out");
    };
    const bool wire = hasWire(from);
    if (from.process != Smaw::kName) refuse("electrode", !from.word("electrode").empty());
    if (wire) refuse("electrode_diameter_mm", from.number("electrode_diameter_mm") > 0);
    if (wire || from.process == Smaw::kName) refuse("rod_diameter_mm", from.number("rod_diameter_mm") > 0);
    if (!wire) refuse("voltage_offset_v", from.number("voltage_offset_v") != 0);
}

} // namespace

int chartJoint(const CaseKind& kind) {
    const auto names = workpieceNames();
    return static_cast<int>(std::find(names.begin(), names.end(), kind.name.substr(kKind.size())) - names.begin());
}

ChartDefaults chartDefaults(TomlTable& table, const CaseKind& kind) {
    ChartDefaults values;
    if (!kind.name.starts_with(kKind) || !table.has("row")) return values;
    const ChartRow row = findRow(table, table.text("row"));
    requireJoint(table, kind, row);
    constexpr double kMm = 1e-3, kMetresPerMinute = 1.0 / 60;
    const bool wire = row.process == Gmaw::kName;
    const char* const diameter = wire ? "wire_diameter_mm" : "electrode_diameter_mm";
    requireWithin(table, diameter, row.diameter, kMm);
    requireWithin(table, "thickness_mm", row.thickness, kMm);
    const auto middle = [&](const char* key, const std::optional<ChartRange>& range, double unit) {
        if (range) values.numbers[key] = range->middle() / unit;
    };
    middle("thickness_mm", row.thickness, kMm);
    middle("gap_mm", row.gap, kMm);
    if (row.diameter && row.diameter->least == row.diameter->most) middle(diameter, row.diameter, kMm);
    middle("rod_diameter_mm", row.rod, kMm);
    middle("current_a", row.current, 1);
    middle("speed_mm_s", row.speed, kMm);
    if (row.leg) values.numbers["leg_mm"] = row.leg->least / kMm;
    if (wire) {
        middle("wire_feed_m_min", row.feed, kMetresPerMinute);
        middle("voltage", row.voltage, 1);
        middle("ctwd_mm", row.tipDistance, kMm);
        if (!row.gases.empty()) values.words["gas"] = row.gases.front()->name;
    }
    values.words["process"] = row.process;
    values.words["electrode"] = row.electrode;
    values.words["position"] = positionOf(row, kind);
    return values;
}

void checkChart(TomlTable& table, const ValidationCase& from) {
    if (!hasWire(from) && from.process.empty())
        table.fail("process", "is missing; expected a row, a wire, or the process gtaw or smaw");
    if (from.process == Smaw::kName) checkElectrode(table, from);
    checkUnused(table, from);
    const std::string& position = from.word("position");
    if (position.empty()) return;
    const auto found = findPosition(position);
    const auto kind = static_cast<WorkpieceKind>(chartJoint(*from.kind));
    if (!found || !positionFits(kind, *found))
        table.fail("position", "is " + quote(position) + "; expected one of " + fittingPositions(kind));
}

} // namespace meltpool
