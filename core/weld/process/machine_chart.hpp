// Makers' charts: machine settings for a joint, thickness, wire and gas, as doors of welding machines print them.
#pragma once

#include "core/weld/process/processes.hpp"
#include "core/weld/process/shielding_gas.hpp"
#include "core/weld/workpiece/workpiece.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// A cell of a chart: one number, or a range.
struct ChartRange {
    double least = 0, most = 0; ///< equal for one number

    double middle() const { return 0.5 * (least + most); }
    /// Returns true if `value` is within the range, or outside by at most `share` of its nearest end.
    bool holds(double value, double share = 0) const;

    bool operator==(const ChartRange&) const = default;
};

/// One row of a chart, SI. An empty cell makes an empty value: the maker does not give it.
struct ChartRow {
    std::string id;                     ///< unique in its file
    std::string source;                 ///< maker, document, page
    bool read = false;                  ///< true: read in the source; false: trade knowledge from memory
    std::string process;                ///< "gmaw", "gtaw" or "smaw"
    std::string transfer;               ///< "dip", "globular" or "spray" of a wire; empty: not given, or no wire
    std::vector<std::string> joints;    ///< names of workpieces; empty: any
    std::vector<std::string> positions; ///< names of positions; empty: any
    std::string metal;                  ///< a shipped material
    std::optional<ChartRange> thickness, gap;
    std::string electrode;                  ///< electrode of SMAW; else empty
    std::optional<ChartRange> diameter;     ///< wire, covered electrode or tungsten
    std::optional<ChartRange> rod;          ///< filler rod
    std::vector<const ShieldingGas*> gases; ///< gases that the row is for; none for SMAW
    std::optional<ChartRange> feed;         ///< m/s of wire
    std::optional<ChartRange> voltage, current;
    std::optional<ChartRange> speed; ///< of travel
    std::optional<ChartRange> tipDistance, leg;
    std::string note;

    /// True if the row is for this gas.
    bool isFor(const ShieldingGas& gas) const;
};

/// Reads one chart, a table with the columns of chartColumns(). Throws InputError with file and line for an unknown
/// column, name or number.
std::vector<ChartRow> readChart(const std::filesystem::path& file);
/// Reads every chart (*.csv) of a folder, in the order of their names; none if there is no such folder.
std::vector<ChartRow> readCharts(const std::filesystem::path& folder);
/// Folder with the charts that ship.
std::filesystem::path chartFolder();

/// Returns the columns of a chart's file.
std::span<const std::string_view> chartColumns();

/// Settings of a machine by one row of a chart.
struct StartingValues {
    const ChartRow* row = nullptr;
    std::optional<ChartRange> feed; ///< m/s of wire
    std::optional<ChartRange> voltage, current;
    bool feedFromCurrent = false; ///< the row gives no feed: it is that which melts at the current, see feedAtCurrent()
    /// V added to the row's voltage, which is for a gas of another arc voltage; 0: it is for this gas.
    double gasVoltage = 0;
};

/// Returns a row's settings for a wire of `diameter` (m), this gas (null: none) and `tipDistance` (m) from contact tip
/// to work where the row gives none. The row of another process than GMAW gives its current alone.
StartingValues startingValues(const ChartRow& row, double diameter, const ShieldingGas* gas, double tipDistance);

/// Returns the settings of all rows that fit these plates, this process and its wire and gas, the best row first: with
/// a thickness, then read in a source, then (without a thickness) with the current of the set feed in its range, then
/// of this gas, then of the nearest thickness. Plates may differ from a row's by kChartSlack, wires by kWireSlack. A
/// row for carbon dioxide serves for a mix of argon and carbon dioxide and the other way round, but not in spray.
/// `tipDistance`: as above; empty: the stick-out.
std::vector<StartingValues> fittingStartingValues(std::span<const ChartRow> rows, const WorkpieceParameters& plates,
                                                  const ProcessSettings& process,
                                                  std::optional<double> tipDistance = {});

/// Returns the position as charts name it: plates that lie as they are made are a level fillet, 2F, or a level seam,
/// 1G.
std::string_view chartPosition(const WorkpieceParameters& plates);

/// Returns the names of workpieces, in the order of WorkpieceKind.
std::span<const std::string_view> workpieceNames();

/// Share by which plates may differ in thickness from a row's. No source: chosen; makers' rows are a factor of 1.25 to
/// 1.6 apart.
inline constexpr double kChartSlack = 0.15;
/// Share by which a wire may differ from a row's: 0.045 in is sold as 1.1 and as 1.2 mm, 0.035 in as 0.9 mm.
inline constexpr double kWireSlack = 0.095;

} // namespace meltpool
