// The tables of the handbook's page of charts, which are made of the charts' files and of the table of gases.
#include "core/base/text.hpp"
#include "core/weld/process/machine_chart.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

using namespace meltpool;

namespace {

constexpr double kInMm = 1e3, kMetresPerMinute = 60;

std::string cell(const std::optional<ChartRange>& range, double scale) {
    if (!range) return {};
    const auto number = [&](double value) { return formatNumber(std::round(value * scale * 100) / 100); };
    const std::string least = number(range->least), most = number(range->most);
    return least == most ? least : least + " to " + most;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return names.empty() ? "any" : text;
}

std::string gasesOf(const ChartRow& row) {
    std::string text;
    for (const ShieldingGas* gas : row.gases)
        text += (text.empty() ? "" : " or ") + std::string(gasText(*gas));
    return text;
}

/// A column of a chart's table.
struct Column {
    std::string head;
    std::function<std::string(const ChartRow&)> text;
};

/// Returns a table without the columns that are empty in every row.
std::string tableOf(const std::vector<const ChartRow*>& rows, const std::vector<Column>& columns) {
    std::vector<Column> used;
    for (const Column& column : columns)
        if (std::any_of(rows.begin(), rows.end(), [&](const ChartRow* row) { return !column.text(*row).empty(); }))
            used.push_back(column);
    std::string text = "|", line = "|";
    for (const Column& column : used) {
        text += " " + column.head + " |";
        line += "---|";
    }
    text += "\n" + line + "\n";
    for (const ChartRow* row : rows) {
        text += "|";
        for (const Column& column : used)
            text += " " + column.text(*row) + " |";
        text += "\n";
    }
    return text;
}

/// Returns the sources in the order of their first rows, with their numbers.
std::vector<std::string> sourcesOf(const std::vector<ChartRow>& rows) {
    std::vector<std::string> sources;
    for (const ChartRow& row : rows)
        if (std::find(sources.begin(), sources.end(), row.source) == sources.end()) sources.push_back(row.source);
    return sources;
}

std::string chartTable(const std::vector<ChartRow>& rows, std::string_view process) {
    const std::vector<std::string> sources = sourcesOf(rows);
    std::vector<const ChartRow*> chosen;
    for (const ChartRow& row : rows)
        if (row.process == process) chosen.push_back(&row);
    return tableOf(chosen,
                   {{"joint", [](const ChartRow& row) { return joined(row.joints); }},
                    {"position", [](const ChartRow& row) { return joined(row.positions); }},
                    {"metal", [](const ChartRow& row) { return row.metal == "s235" ? std::string() : row.metal; }},
                    {"plate, mm", [](const ChartRow& row) { return cell(row.thickness, kInMm); }},
                    {"gap, mm", [](const ChartRow& row) { return cell(row.gap, kInMm); }},
                    {"electrode", [](const ChartRow& row) { return row.electrode; }},
                    {"wire or electrode, mm", [](const ChartRow& row) { return cell(row.diameter, kInMm); }},
                    {"rod, mm", [](const ChartRow& row) { return cell(row.rod, kInMm); }},
                    {"gas", [&](const ChartRow& row) { return process == "gtaw" ? std::string() : gasesOf(row); }},
                    {"transfer", [](const ChartRow& row) { return row.transfer; }},
                    {"feed, m/min", [](const ChartRow& row) { return cell(row.feed, kMetresPerMinute); }},
                    {"V", [](const ChartRow& row) { return cell(row.voltage, 1); }},
                    {"A", [](const ChartRow& row) { return cell(row.current, 1); }},
                    {"travel, mm/s", [](const ChartRow& row) { return cell(row.speed, kInMm); }},
                    {"tip, mm", [](const ChartRow& row) { return cell(row.tipDistance, kInMm); }},
                    {"leg, mm", [](const ChartRow& row) { return cell(row.leg, kInMm); }},
                    {"remark", [](const ChartRow& row) { return row.note; }},
                    {"source", [&](const ChartRow& row) {
                         const auto found = std::find(sources.begin(), sources.end(), row.source);
                         return std::to_string(found - sources.begin() + 1) + (row.read ? "" : " (M)");
                     }}});
}

std::string sourceList(const std::vector<ChartRow>& rows) {
    std::string text;
    int number = 0;
    for (const std::string& source : sourcesOf(rows))
        text += std::to_string(++number) + ". " + source + "\n";
    return text;
}

std::string gasTable() {
    std::string text = "| gas | in lessons | arc voltage, V | a wire of 1 mm sprays from, A | spatter, times |\n"
                       "|---|---|---|---|---|\n";
    for (const ShieldingGas& gas : shieldingGases())
        text += "| " + std::string(gasText(gas)) + " | `" + std::string(gas.name) + "` | " +
                (gas.arcVoltage > 0 ? "+" : "") + formatNumber(gas.arcVoltage) + " | " +
                (gas.sprayCurrent ? formatNumber(*gas.sprayCurrent) : "never") + " | " + formatNumber(gas.spatter) +
                " |\n";
    return text;
}

/// Returns the page with the tables between its marks made again. Throws if a mark is missing.
std::string filledPage(const std::string& page, const std::map<std::string, std::string>& tables) {
    std::string filled = page;
    for (const auto& [name, table] : tables) {
        const std::string begin = "<!-- chart: " + name + " -->\n", end = "<!-- end of chart -->";
        const size_t from = filled.find(begin), to = filled.find(end, from);
        INFO(name);
        REQUIRE(from != std::string::npos);
        REQUIRE(to != std::string::npos);
        filled.replace(from + begin.size(), to - from - begin.size(), "\n" + table + "\n");
    }
    return filled;
}

} // namespace

TEST_CASE("the tables of the handbook's page of charts are those of the data", "[weld][chart]") {
    const auto file = test::sourceFolder() / "app" / "handbook" / "chart.md";
    const std::vector<ChartRow> rows = readCharts(test::sourceFolder() / "app" / "data" / "charts");
    const std::string page = readTextFile(file);
    const std::string filled = filledPage(page, {{"gmaw", chartTable(rows, "gmaw")},
                                                 {"gtaw", chartTable(rows, "gtaw")},
                                                 {"smaw", chartTable(rows, "smaw")},
                                                 {"sources", sourceList(rows)},
                                                 {"gases", gasTable()}});
    const char* approve = std::getenv("MELTPOOL_APPROVE");
    if (approve != nullptr && std::string(approve) == "1") return writeTextFileAtomically(file, filled);
    INFO("MELTPOOL_APPROVE=1 build/release/bin/test_weld \"[chart]\" writes the tables");
    CHECK(page == filled);
    // Each process has its rows there: an empty table would equal an empty page.
    for (const std::string_view process : {"gmaw", "gtaw", "smaw"})
        CHECK(std::count_if(rows.begin(), rows.end(), [&](const ChartRow& row) { return row.process == process; }) > 5);
}

TEST_CASE("the handbook names every column of a chart's file", "[weld][chart]") {
    const std::string page = readTextFile(test::sourceFolder() / "app" / "handbook" / "chart.md");
    for (const std::string_view column : chartColumns()) {
        INFO(column);
        CHECK(page.find("`" + std::string(column) + "`") != std::string::npos);
    }
}
