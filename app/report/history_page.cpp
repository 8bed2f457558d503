#include "app/report/history_page.hpp"

#include "app/report/curve_scale.hpp"
#include "app/report/page_text.hpp"
#include "app/report/svg_text.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kWidth = 300, kHeight = 130; // units of a drawing

constexpr const char* kStyle = R"(
body { font: 10pt/1.35 sans-serif; color: #1c1f24; max-width: 280mm; margin: 8mm auto; padding: 0 4mm }
h1 { font-size: 17pt; margin: 0 } h2 { font-size: 13pt; margin: 8mm 0 1mm } h3 { font-size: 11pt; margin: 4mm 0 1mm }
.quiet { color: #5b6470 } .series { display: flex; flex-wrap: wrap; gap: 4mm } figure { margin: 0; width: 86mm }
figcaption { font-weight: bold } svg { width: 100%; height: auto; display: block }
svg text { font: 9px sans-serif; fill: #3a424c } .axis { stroke: #8a929c }
.values { fill: none; stroke: #1f5fbf; stroke-width: 1.4 } .dot { fill: #1f5fbf }
table { border-collapse: collapse } td, th { padding: 0.4mm 2mm; text-align: left; border-bottom: 1px solid #dde1e6 }
td.n, th.n { text-align: right } summary { color: #1f5fbf; cursor: pointer }
)";

/// Value with three significant digits, in its unit.
std::string valueText(const HistorySeries& series, double value) {
    const double size = std::abs(value);
    const int decimals = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
    return numberText(value, decimals) + (series.unit.empty() ? "" : " " + series.unit);
}

double secondsOf(Moment moment) {
    return std::chrono::duration<double>(moment.time_since_epoch()).count();
}

/// Day of a result: "2026-11-25".
std::string dayOf(Moment moment) {
    return utcText(moment).substr(0, 10);
}

std::string pointText(const HistorySeries& series, const HistoryPoint& point) {
    return phrase("history.point", {{"value", valueText(series, point.value)},
                                    {"commit", printable(point.commit, 60)},
                                    {"day", dayOf(point.made)}});
}

std::string drawingOf(const HistorySeries& series) {
    CurveSheet sheet{8, 16, kWidth - 8, kHeight - 16, {}, {}};
    sheet.values.take(0);
    for (const HistoryPoint& point : series.points) {
        sheet.places.take(secondsOf(point.made));
        sheet.values.take(point.value);
    }
    SvgText svg(kWidth, kHeight, series.name);
    svg.line(sheet.left, sheet.y(0), sheet.right, sheet.y(0), "axis");
    std::string line;
    for (const HistoryPoint& point : series.points)
        line += (line.empty() ? "" : " ") + SvgText::point(sheet.x(secondsOf(point.made)), sheet.y(point.value));
    svg.polyline(line, "values");
    for (const HistoryPoint& point : series.points)
        svg.dot(sheet.x(secondsOf(point.made)), sheet.y(point.value), "dot", pointText(series, point));
    const HistoryPoint &first = series.points.front(), &last = series.points.back();
    svg.word(sheet.left, kHeight - 3, "start", dayOf(first.made));
    if (series.points.size() > 1) {
        svg.word(sheet.left, 10, "start", valueText(series, first.value));
        svg.word(sheet.right, kHeight - 3, "end", dayOf(last.made));
    }
    svg.word(sheet.right, 10, "end", valueText(series, last.value));
    return svg.element();
}

std::string tableOf(const HistorySeries& series) {
    const auto count = static_cast<long long>(series.points.size());
    std::string rows;
    for (const HistoryPoint& point : series.points)
        rows += "<tr><td>" + dayOf(point.made) + "</td><td>" + escaped(point.commit) + "</td>" +
                numberCell(escaped(valueText(series, point.value))) + "</tr>\n";
    return "<details><summary>" + phraseOfCount("history.results", count, {{"count", PhraseNumber(static_cast<double>(count))}}) +
           "</summary><table>" + rows + "</table></details>\n";
}

std::string machinePart(const MachineHistory& machine) {
    std::string html = "<h2>" + escaped(machine.machine) + "</h2>\n", group;
    for (const HistorySeries& series : machine.series) {
        if (series.group != group)
            html += (group.empty() ? "" : "</div>\n") + ("<h3>" + escaped(series.group)) +
                    "</h3>\n<div class=\"series\">\n";
        group = series.group;
        html += "<figure><figcaption>" + escaped(series.name) + "</figcaption>\n" + drawingOf(series) +
                tableOf(series) + "</figure>\n";
    }
    return html + (group.empty() ? "" : "</div>\n");
}

} // namespace

std::string historyPage(const ResultHistory& history) {
    std::string parts;
    for (const MachineHistory& machine : history.machines)
        parts += machinePart(machine);
    if (parts.empty()) parts = "<p>" + phrase("history.empty") + "</p>\n";
    const std::string title = phrase("history.title");
    return "<!DOCTYPE html>\n<html lang=\"" + std::string(language()) +
           "\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + title + " – Meltpool</title>\n<style>" + kStyle +
           "</style>\n</head>\n<body>\n<main>\n<h1>" + title + "</h1>\n<p class=\"quiet\">" + phrase("history.note") +
           "</p>\n" + parts + "</main>\n</body>\n</html>\n";
}

} // namespace meltpool
