// The part of the page about the hand: the score of each quantity, and the curves along the seam.
#include "app/report/curve_drawing.hpp"
#include "app/report/page_parts.hpp"
#include "app/report/page_text.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/training/judging/quantity.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

using nlohmann::json;

/// Quantity of a key of result.json, for any kind of the process's distance; null for none.
const QuantityInfo* quantityOf(const std::string& key) {
    for (const DistanceKind kind : {DistanceKind::ctwd, DistanceKind::arcLength})
        for (const QuantityInfo& info : quantities(kind))
            if (!info.key.empty() && info.key == key) return &info;
    return nullptr;
}

std::string points(std::optional<double> value) {
    return value ? numberText(*value, 1) : std::string(kDash);
}

std::string techniqueRow(const QuantityInfo& info, const json& score, const json& value) {
    const std::string key(info.key), unit(info.unit);
    const auto ideal = numberIn(value, "ideal"), inner = numberIn(value, "inner");
    const std::string asked = ideal ? measure(ideal, unit) + " \xC2\xB1 " + measure(inner, unit) : std::string(kDash);
    return "<tr><td>" + capitalised(info.words()) + "</td>" +
           numberCell(points(numberIn(partIn(score, "parameters"), key.c_str()))) +
           numberCell(points(numberIn(value, "lost_points"))) + numberCell(measure(numberIn(value, "mean"), unit)) +
           numberCell(asked) + numberCell(measure(numberIn(value, "worst_at_mm"), "mm")) + "</tr>\n";
}

std::optional<CurveBand> bandOf(const json& value) {
    const auto ideal = numberIn(value, "ideal"), inner = numberIn(value, "inner"), outer = numberIn(value, "outer");
    if (!ideal || !inner || !outer) return std::nullopt;
    return CurveBand{*ideal, *inner, *outer};
}

/// Curve of a column of technique.csv; empty if it has no values.
std::string drawn(const RunResults& results, std::string_view column, std::string title, std::string_view unit,
                  std::optional<CurveBand> band) {
    return curveDrawing({std::move(title), std::string(unit), results.technique.column("place_mm"),
                         results.technique.column(column), band});
}

/// Curves for a lesson that judges no technique: those that matter in every weld.
std::string plainCurves(const RunResults& results) {
    std::string curves;
    for (const DistanceKind kind : {DistanceKind::ctwd, DistanceKind::arcLength})
        for (const TechniqueQuantity quantity :
             {TechniqueQuantity::travelSpeed, TechniqueQuantity::workAngle, TechniqueQuantity::travelAngle,
              TechniqueQuantity::distance, TechniqueQuantity::aim}) {
            // The two kinds differ only in the distance.
            if (kind == DistanceKind::arcLength && quantity != TechniqueQuantity::distance) continue;
            const QuantityInfo& info = quantityInfo(quantity, kind);
            curves += drawn(results, info.column, capitalised(info.words()), info.unit, {});
        }
    return curves;
}

} // namespace

std::string techniquePart(const RunResults& results) {
    const json& score = partIn(results.result, "score");
    const json& values = partIn(score, "values");
    if (!values.is_object() || values.empty()) return {};
    std::string rows;
    for (const auto& [key, value] : values.items())
        if (const QuantityInfo* info = quantityOf(key)) rows += techniqueRow(*info, score, value);
    if (const auto lost = numberIn(score, "lost_to_length_points"); lost && *lost > 0)
        rows += "<tr><td>" + phrase("page.hand.not_welded") + "</td>" + numberCell(kDash) + numberCell(points(lost)) +
                numberCell(kDash) + numberCell(kDash) + numberCell(kDash) + "</tr>\n";
    return "<h2>" + phrase("page.hand.heading") + "</h2>\n<table><thead><tr>" +
           headCells({"page.hand.column.technique", "page.hand.column.points", "page.hand.column.lost",
                      "page.hand.column.mean", "page.hand.column.asked", "page.hand.column.worst"}) +
           "</tr></thead>\n<tbody>" + rows + "</tbody></table>\n";
}

std::string curvePart(const RunResults& results) {
    const json& values = partIn(partIn(results.result, "score"), "values");
    std::string curves;
    if (values.is_object())
        for (const auto& [key, value] : values.items())
            if (const QuantityInfo* info = quantityOf(key))
                curves += drawn(results, info->column, capitalised(info->words()), info->unit, bandOf(value));
    const bool judged = !curves.empty();
    if (!judged) curves = plainCurves(results);
    const auto volts = results.technique.column("voltage_v");
    if (std::any_of(volts.begin(), volts.end(), [](double value) { return value > 0; }))
        curves += drawn(results, "current_a", phrase("page.curves.current"), "A", {}) +
                  drawn(results, "voltage_v", phrase("page.curves.voltage"), "V", {});
    if (curves.empty()) return "<p class=\"quiet\">" + phrase("page.curves.none") + "</p>\n";
    return "<h2>" + phrase("page.curves.heading") + "</h2>\n<div class=\"pair\">\n" + curves + "</div>\n" +
           (judged ? "<p class=\"quiet\">" + phrase("page.curves.legend") + "</p>\n" : "");
}

} // namespace meltpool
