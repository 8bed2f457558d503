#include "core/weld/process/machine_chart.hpp"

#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/table_reader.hpp"
#include "core/base/text.hpp"
#include "core/weld/process/wire_arc.hpp"
#include "core/weld/workpiece/position.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3, kMetresPerMinute = 1.0 / 60;
constexpr std::string_view kAny = "any";

constexpr std::array<std::string_view, 21> kColumns{
    "id",         "source",       "mark",    "process",    "transfer",        "joint",  "position",
    "metal",      "thickness_mm", "gap_mm",  "electrode",  "diameter_mm",     "rod_mm", "gas",
    "feed_m_min", "voltage",      "current", "speed_mm_s", "tip_distance_mm", "leg_mm", "note"};

constexpr std::array<std::string_view, 2> kMarks{"read", "memory"};
constexpr std::array<std::string_view, 3> kTransfers{"dip", "globular", "spray"};

std::string joined(std::span<const std::string_view> names) {
    std::string text;
    for (const std::string_view name : names)
        text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
}

/// Reads the rows of one file.
class ChartReader {
  public:
    explicit ChartReader(const std::filesystem::path& file) : file_(file), table_(readTextFile(file), file, isColumn) {
        for (const std::string& name : table_.columns())
            if (!isColumn(name))
                fail(table_.headerLine(), "has the column " + quote(name) + "; expected some of " + joined(kColumns));
    }

    std::vector<ChartRow> read() {
        std::vector<ChartRow> rows;
        for (TableReader::Item item = table_.next(); item != TableReader::Item::end; item = table_.next())
            if (item == TableReader::Item::row) rows.push_back(readRow());
        return rows;
    }

  private:
    static bool isColumn(std::string_view name) {
        return std::find(kColumns.begin(), kColumns.end(), name) != kColumns.end();
    }

    [[noreturn]] void fail(int line, const std::string& sentence) const { throw InputError(file_, line, sentence); }
    [[noreturn]] void refuse(std::string_view column, std::string_view cell, const std::string& expected) const {
        fail(table_.line(), std::string(column) + " is " + quote(cell) + "; expected " + expected);
    }

    /// Returns the cell of a column; empty if the file lacks the column.
    std::string_view cell(std::string_view column) const {
        const auto& columns = table_.columns();
        const auto place = static_cast<size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
        return place < table_.cells().size() ? table_.cells()[place] : std::string_view();
    }

    std::string needed(std::string_view column) const {
        if (cell(column).empty()) fail(table_.line(), std::string(column) + " is empty; expected a text");
        return std::string(cell(column));
    }

    std::string oneOf(std::string_view column, std::span<const std::string_view> names) const {
        const std::string_view name = cell(column);
        if (std::find(names.begin(), names.end(), name) == names.end()) refuse(column, name, "one of " + joined(names));
        return std::string(name);
    }

    /// Returns the names in a cell, between slashes; none for "any".
    std::vector<std::string> someOf(std::string_view column, std::span<const std::string_view> names) const {
        std::vector<std::string> found;
        if (cell(column) == kAny) return found;
        for (const std::string_view part : splitText(cell(column), '/')) {
            const std::string_view name = trimText(part);
            if (std::find(names.begin(), names.end(), name) == names.end())
                refuse(column, name, "any, or some of " + joined(names) + " with slashes between them");
            found.emplace_back(name);
        }
        return found;
    }

    /// Returns the range of a cell, "19-21" or "20", times `unit`; nothing for an empty cell.
    std::optional<ChartRange> range(std::string_view column, double unit) {
        const std::string_view text = cell(column);
        if (text.empty()) return std::nullopt;
        const auto parts = splitText(text, '-');
        const auto first = table_.number(trimText(parts.front())), last = table_.number(trimText(parts.back()));
        if (parts.size() > 2 || !first || !last || !(*first >= 0) || !(*last >= *first) || !std::isfinite(*last))
            refuse(column, text, "a number from 0, or a range such as 19-21");
        return ChartRange{*first * unit, *last * unit};
    }

    std::vector<const ShieldingGas*> gases() const {
        std::vector<const ShieldingGas*> found;
        if (cell("gas").empty()) return found;
        for (const std::string& name : someOf("gas", shieldingGasNames()))
            found.push_back(findShieldingGas(name));
        return found;
    }

    ChartRow readRow() {
        table_.requireWidth();
        ChartRow row;
        row.id = needed("id");
        if (!ids_.insert(row.id).second) refuse("id", row.id, "another name: an earlier row has this one");
        row.source = needed("source");
        row.read = oneOf("mark", kMarks) == kMarks[0];
        row.process = oneOf("process", AllProcesses::kNames);
        if (!cell("transfer").empty()) row.transfer = oneOf("transfer", kTransfers);
        row.joints = someOf("joint", workpieceNames());
        row.positions = someOf("position", positionNames());
        row.metal = needed("metal");
        row.thickness = range("thickness_mm", kMm);
        row.gap = range("gap_mm", kMm);
        row.electrode = cell("electrode");
        row.diameter = range("diameter_mm", kMm);
        row.rod = range("rod_mm", kMm);
        row.gases = gases();
        row.feed = range("feed_m_min", kMetresPerMinute);
        row.voltage = range("voltage", 1);
        row.current = range("current", 1);
        row.speed = range("speed_mm_s", kMm);
        row.tipDistance = range("tip_distance_mm", kMm);
        row.leg = range("leg_mm", kMm);
        row.note = cell("note");
        if (!row.feed && !row.current)
            fail(table_.line(), "has neither feed_m_min nor current; expected at least one of them");
        return row;
    }

    std::filesystem::path file_;
    TableReader table_;
    std::set<std::string> ids_;
};

/// Returns the voltage (V) to add to a row's for another gas; nothing if the row does not serve for it.
std::optional<double> gasVoltage(const ChartRow& row, const ShieldingGas* gas) {
    if (gas == nullptr || row.gases.empty() || row.isFor(*gas)) return 0;
    const auto isMixed = [](const ShieldingGas& one) {
        return &one == &shieldingGas(GasKind::arCo2) || &one == &shieldingGas(GasKind::co2);
    };
    if (row.transfer == "spray" || !isMixed(*gas) || !isMixed(*row.gases.front())) return std::nullopt;
    return gas->arcVoltage - row.gases.front()->arcVoltage;
}

ChartRange shifted(const ChartRange& range, double by) {
    return {range.least + by, range.most + by};
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

bool ChartRange::holds(double value, double share) const {
    return value >= least * (1 - share) && value <= most * (1 + share);
}

bool ChartRow::isFor(const ShieldingGas& gas) const {
    return std::find(gases.begin(), gases.end(), &gas) != gases.end();
}

std::string_view chartPosition(const WorkpieceParameters& plates) {
    const auto position = static_cast<WeldPosition>(plates.position);
    const auto kind = static_cast<WorkpieceKind>(plates.kind);
    const auto name = [](WeldPosition one) { return positionNames()[static_cast<size_t>(one)]; };
    if (position == WeldPosition::flat && positionFits(kind, WeldPosition::f1)) return name(WeldPosition::f1);
    if (position != WeldPosition::asItLies && position != WeldPosition::flat) return name(position);
    if (kind == WorkpieceKind::Corner) return name(WeldPosition::f1);
    return name(positionFits(kind, WeldPosition::f2) ? WeldPosition::f2 : WeldPosition::g1);
}

std::span<const std::string_view> workpieceNames() {
    WorkpieceParameters parameters;
    return findParameter(describe(parameters), "workpiece")->choices;
}

std::span<const std::string_view> chartColumns() {
    return kColumns;
}

std::vector<ChartRow> readChart(const std::filesystem::path& file) {
    return ChartReader(file).read();
}

std::vector<ChartRow> readCharts(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
        if (lowerExtension(entry.path()) == ".csv") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<ChartRow> all;
    for (const std::filesystem::path& file : files)
        for (ChartRow& row : readChart(file))
            all.push_back(std::move(row));
    return all;
}

std::filesystem::path chartFolder() {
    return resourceFolder() / "data" / "charts";
}

StartingValues startingValues(const ChartRow& row, double diameter, const ShieldingGas* gas, double tipDistance) {
    StartingValues values{.row = &row, .feed = row.feed, .voltage = row.voltage, .current = row.current};
    values.gasVoltage = gasVoltage(row, gas).value_or(0);
    if (values.voltage) values.voltage = shifted(*values.voltage, values.gasVoltage);
    if (row.process != Gmaw::kName || values.feed || !values.current) return values;
    WireFeed machine{.melting = WireMelting::steel(diameter)};
    if (gas != nullptr) machine.gasVoltage = gas->arcVoltage;
    const double distance = row.tipDistance ? row.tipDistance->middle() : tipDistance;
    const auto feedAt = [&](double current, double voltage) {
        machine.voltage = voltage;
        return feedAtCurrent(machine, distance, current);
    };
    const ChartRange voltage = values.voltage.value_or(ChartRange{});
    values.feed = {feedAt(values.current->least, voltage.least), feedAt(values.current->most, voltage.most)};
    values.feedFromCurrent = true;
    return values;
}

std::vector<StartingValues> fittingStartingValues(std::span<const ChartRow> rows, const WorkpieceParameters& plates,
                                                  const ProcessSettings& process, std::optional<double> tipDistance) {
    const Equipment tools = equipmentOf(process);
    const double distance = tipDistance.value_or(tools.heldBehind);
    const double thickness = static_cast<double>(plates.thicknessMm) * kMm;
    const double consumable = std::max(tools.wire, tools.electrode);
    const auto fits = [&](const ChartRow& row) {
        if (row.process != traitsOf(process).name || row.metal != plates.metal) return false;
        if (!contains(row.joints, workpieceNames()[static_cast<size_t>(plates.kind)])) return false;
        if (!contains(row.positions, chartPosition(plates))) return false;
        if (row.thickness && !row.thickness->holds(thickness, kChartSlack)) return false;
        if (!row.electrode.empty() && row.electrode != tools.electrodeName) return false;
        if (consumable > 0 && row.diameter && !row.diameter->holds(consumable, kWireSlack)) return false;
        return gasVoltage(row, tools.gas).has_value();
    };
    std::vector<StartingValues> found;
    for (const ChartRow& row : rows)
        if (fits(row)) found.push_back(startingValues(row, tools.wire, tools.gas, distance));
    const double set = tools.wire > 0 ? WireMelting::steel(tools.wire).current(tools.wireSpeed, distance) : 0;
    const auto order = [&](const StartingValues& values) {
        const ChartRow& row = *values.row;
        const double off = row.thickness ? std::abs(row.thickness->middle() - thickness) : 0;
        const bool otherCurrent = !row.thickness && set > 0 && row.current && !row.current->holds(set);
        return std::tuple(!row.thickness, !row.read, otherCurrent, values.gasVoltage != 0, off);
    };
    std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) { return order(a) < order(b); });
    return found;
}

} // namespace meltpool
