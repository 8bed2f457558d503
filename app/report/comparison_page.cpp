#include "app/report/comparison_page.hpp"

#include "app/report/page_text.hpp"
#include "app/report/report_page.hpp"
#include "app/report/twin_curve.hpp"
#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool {

namespace {

using nlohmann::json;

constexpr const char* kStyle = R"(
@page { size: A4; margin: 14mm }
body { font: 10pt/1.35 sans-serif; color: #1c1f24; max-width: 190mm; margin: 8mm auto; padding: 0 4mm }
h1 { font-size: 17pt; margin: 0 } h2 { font-size: 12pt; margin: 6mm 0 2mm; break-after: avoid }
table { border-collapse: collapse; width: 100% } td, th { padding: 0.6mm 2mm; text-align: left; border-bottom: 1px solid #dde1e6 }
td.n, th.n { text-align: right; white-space: nowrap } .quiet { color: #5b6470 } .differs td { font-weight: bold }
svg { width: 100%; height: auto; display: block; break-inside: avoid } svg text { font: 9px sans-serif; fill: #3a424c }
.outer { fill: #f2efe2 } .inner { fill: #d9ead9 } .ideal { stroke: #2f7d4a; stroke-dasharray: 2 4 }
.axis { stroke: #8a929c } .first { fill: none; stroke: #a34a00; stroke-width: 1.4; stroke-dasharray: 6 3 }
.second { fill: none; stroke: #1f5fbf; stroke-width: 1.4 }
.pair { break-inside: avoid } .pair img { width: 49%; vertical-align: top }
input[name=unit] { accent-color: #1f5fbf } .in { display: none }
#inch:checked ~ main .in { display: inline } #inch:checked ~ main .mm { display: none }
@media print { input, label { display: none } }
)";

/// Number with its unit, a length also in inches, of which the page shows one. `sign`: a plus before positive numbers.
std::string withInches(double value, const std::string& unit, int decimals, bool sign) {
    const auto text = [&](double number, int places, const std::string& name) {
        const char* gap = name.empty() || name == "%" || name == "°" ? "" : " ";
        return numberText(number, places, sign) + gap + escaped(name);
    };
    const ShownUnit inch = inchUnit(unit);
    if (!inch.converts()) return text(value, decimals, unit);
    return "<span class=\"mm\">" + text(value, decimals, unit == "mm2" ? "mm²" : unit) + "</span><span class=\"in\">" +
           text(value * inch.perMetric, std::max(decimals + inch.digits, 0), std::string(inch.name)) + "</span>";
}

/// Result of a repetition against its recording, and the verdict, in a few words.
std::string describe(const ComparedRun& run) {
    const json& result = run.results.result;
    std::string text = textIn(result, "lesson") + " · " + textIn(result, "torch");
    if (const auto found = result.find("recorded"); found != result.end())
        if (const std::string kind = textIn(*found, "repetition"); !kind.empty()) text += " · " + kind;
    if (const auto found = result.find("verdict"); found != result.end() && found->is_object())
        text += " · " + phrase(found->value("accepted", json()) == true ? "comparison_page.accepted"
                                                                        : "comparison_page.not_accepted");
    return text + " · " + phrase("comparison_page.state", {{"state", textIn(result, "state_hash")}});
}

std::string titleOf(const ComparedRun& first, const ComparedRun& second) {
    return phrase("comparison_page.title", {{"second", escaped(second.name)}, {"first", escaped(first.name)}});
}

std::string headPart(const ComparedRun& first, const ComparedRun& second) {
    std::string html = "<h1>" + titleOf(first, second) + "</h1>\n";
    for (const ComparedRun* run : {&first, &second})
        html += "<p class=\"quiet\">" +
                phrase("comparison_page.attempt", {{"attempt", escaped(run->name)}, {"facts", describe(*run)}}) +
                "</p>\n";
    if (textIn(first.results.result, "lesson") != textIn(second.results.result, "lesson"))
        html += "<p>" + phrase("comparison_page.other_lesson") + "</p>\n";
    return html;
}

std::string wordsPart(const Comparison& comparison) {
    std::string list;
    for (const FigurePair& pair : comparison.differences())
        list += "<li>" + pair.told(withInches(std::abs(pair.difference()), pair.figure.unit, pair.decimals(), false)) +
                "</li>\n";
    if (const auto points = comparison.morePoints())
        list +=
            "<li>" +
            phrase(*points > 0 ? "comparison_page.difference.points_more" : "comparison_page.difference.points_less",
                   {{"points", PhraseNumber(std::abs(*points))}}) +
            "</li>\n";
    std::string html = "<h2>" + phrase("comparison_page.difference.heading") + "</h2>\n";
    html += list.empty() ? "<p>" + phrase("comparison_page.difference.none") + "</p>\n" : "<ol>\n" + list + "</ol>\n";
    if (comparison.halfSpacing > 0)
        html += "<p class=\"quiet\">" +
                phrase("comparison_page.difference.resolved",
                       {{"length", withInches(comparison.halfSpacing * 1e3, "mm", 2, false)}}) +
                "</p>\n";
    return html;
}

std::string headsOf(const std::string& what, const ComparedRun& first, const ComparedRun& second) {
    return "<tr><th>" + what + "</th><th class=\"n\">" + escaped(first.name) + "</th><th class=\"n\">" +
           escaped(second.name) + "</th><th class=\"n\">" + phrase("comparison_page.column.difference") +
           "</th></tr>\n";
}

std::string rowOf(const std::string& name, const std::string& first, const std::string& second,
                  const std::string& difference) {
    return "<tr" + std::string(difference.empty() ? "" : " class=\"differs\"") + "><td>" + escaped(name) +
           "</td><td class=\"n\">" + first + "</td><td class=\"n\">" + second + "</td><td class=\"n\">" +
           (difference.empty() ? "–" : difference) + "</td></tr>\n";
}

std::string scorePart(const Comparison& comparison, const ComparedRun& first, const ComparedRun& second) {
    if (comparison.scores.empty()) return {};
    const auto points = [](const std::optional<double>& value) {
        return value ? numberText(*value, 0) : std::string("–");
    };
    std::string html = "<h2>" + phrase("comparison_page.points.heading") + "</h2>\n<table>\n" +
                       headsOf(phrase("comparison_page.column.technique"), first, second);
    for (const ScorePair& pair : comparison.scores) {
        std::string difference;
        if (pair.first && pair.second && std::abs(*pair.second - *pair.first) >= 1)
            difference = withInches(*pair.second - *pair.first, "", 0, true);
        html += rowOf(pair.name, points(pair.first), points(pair.second), difference);
    }
    return html + "</table>\n";
}

std::string figuresPart(const Comparison& comparison, const ComparedRun& first, const ComparedRun& second) {
    constexpr std::array<std::pair<FigureGroup, const char*>, 3> kGroups{
        {{FigureGroup::weld, "weld"}, {FigureGroup::hand, "hand"}, {FigureGroup::arc, "arc"}}};
    std::string html;
    for (const auto& [group, name] : kGroups) {
        std::string rows;
        for (const FigurePair& pair : comparison.pairs) {
            if (pair.figure.group != group) continue;
            const auto shown = [&](double value) {
                return withInches(value, pair.figure.unit, pair.decimals(), false);
            };
            rows += rowOf(pair.figure.name, shown(pair.first), shown(pair.second),
                          pair.differs() ? withInches(pair.difference(), pair.figure.unit, pair.decimals(), true) : "");
        }
        if (!rows.empty())
            html += "<h2>" + phraseOf("comparison_page.group", name) + "</h2>\n<table>\n" +
                    headsOf(phrase("comparison_page.column.mean"), first, second) + rows + "</table>\n";
    }
    return html;
}

std::string pictureOf(const ReportPicture& picture, const std::string& attempt) {
    const std::string caption = phrase("comparison_page.picture", {{"picture", picture.name}, {"attempt", attempt}});
    return "<img alt=\"" + escaped(caption) + "\" src=\"data:image/png;base64," + base64(picture.png) + "\">\n";
}

std::string picturesPart(const ComparedRun& first, const ComparedRun& second) {
    std::string html;
    for (const auto& one : first.results.pictures)
        for (const auto& other : second.results.pictures)
            if (one.name == other.name)
                html += "<div class=\"pair\">\n<h2>" + escaped(one.name) + "</h2>\n" + pictureOf(one, first.name) +
                        pictureOf(other, second.name) + "</div>\n";
    if (html.empty()) return html;
    return "<p class=\"quiet\">" +
           phrase("comparison_page.sides", {{"first", escaped(first.name)}, {"second", escaped(second.name)}}) +
           "</p>\n" + html;
}

Curve curveOf(const NumberTable& table, std::string_view column, const std::string& title, const std::string& unit) {
    Curve curve{title, unit, table.column("place_mm"), table.column(column), std::nullopt};
    return curve.values.size() == curve.places.size() ? curve : Curve{title, unit, {}, {}, std::nullopt};
}

/// Band of the first attempt's lesson for a quantity.
std::optional<CurveBand> bandOf(const json& result, const std::string& key) {
    try {
        const json& value = result.at("score").at("values").at(key);
        return CurveBand{value.at("ideal").get<double>(), value.at("inner").get<double>(),
                         value.at("outer").get<double>()};
    } catch (const json::exception&) {
        return std::nullopt;
    }
}

std::string curvesPart(const Comparison& comparison, const ComparedRun& first, const ComparedRun& second) {
    std::string weld, hand;
    const DistanceKind distance = figuresOf(second.results).distance;
    for (const FigurePair& pair : comparison.pairs) {
        const ComparedFigure& figure = pair.figure;
        if (figure.group == FigureGroup::weld && pair.isDrawn())
            weld += twinCurveDrawing(curveOf(first.results.weld, figure.key, figure.name, figure.unit),
                                     curveOf(second.results.weld, figure.key, figure.name, figure.unit));
        for (const QuantityInfo& info : quantities(distance)) {
            if (figure.group != FigureGroup::hand || info.key != figure.key) continue;
            Curve one = curveOf(first.results.technique, info.column, figure.name, figure.unit);
            one.band = bandOf(first.results.result, figure.key);
            hand += twinCurveDrawing(one, curveOf(second.results.technique, info.column, figure.name, figure.unit));
        }
    }
    if (weld.empty() && hand.empty()) return {};
    return "<h2>" + phrase("comparison_page.curves.heading") + "</h2>\n<p class=\"quiet\">" +
           phrase("comparison_page.curves.lines", {{"first", escaped(first.name)}, {"second", escaped(second.name)}}) +
           "</p>\n" + hand + weld;
}

} // namespace

std::string comparisonPage(const ComparedRun& first, const ComparedRun& second) {
    const Comparison comparison = compareRuns(first, second);
    return "<!DOCTYPE html>\n<html lang=\"" + std::string(language()) +
           "\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + titleOf(first, second) + " – Meltpool</title>\n<style>" +
           kStyle + "</style>\n</head>\n<body>\n" + unitSwitch() + "<main>\n" + headPart(first, second) +
           wordsPart(comparison) + scorePart(comparison, first, second) + figuresPart(comparison, first, second) +
           picturesPart(first, second) + curvesPart(comparison, first, second) + "</main>\n</body>\n</html>\n";
}

} // namespace meltpool
