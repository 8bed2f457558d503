// The part of the page with the measured weld and the arc in figures.
#include "app/report/page_parts.hpp"
#include "app/report/page_text.hpp"
#include "app/report/svg_text.hpp"
#include "core/base/words.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <array>
#include <functional>
#include <set>
#include <string_view>

namespace meltpool {

namespace {

using nlohmann::json;

/// Entry of `arc` in result.json. Its words are figure.KEY.name.
struct ArcFigure {
    std::string_view key, unit;
    int decimals = -1; ///< -1: the digits of its unit
};

constexpr std::array kArcFigures{
    ArcFigure{"mean_current_a", "A", 0}, ArcFigure{"mean_voltage_v", "V", 1}, ArcFigure{"energy_kj", "kJ", 1},
    ArcFigure{"seconds", "s", 1},        ArcFigure{"seam_mm", "mm"},          ArcFigure{"travel_speed_mm_s", "mm/s"},
};

/// Entries in the formula below the table.
constexpr std::array<std::string_view, 2> kInFormula{"efficiency_en_1011_1", "heat_input_kj_mm"};

/// Text of a value: lengths and the like in both systems of units, shares and counts with the table's digits.
std::string valueText(const WeldFigure& figure, double value) {
    if (figure.unit.empty()) return numberText(value, figure.digits);
    return figure.unit == "%" ? numberText(value, figure.digits) + " %" : measure(value, figure.unit);
}

std::string valueText(const ArcFigure& figure, double value) {
    return figure.decimals < 0 ? measure(value, figure.unit)
                               : numberText(value, figure.decimals) + " " + std::string(figure.unit);
}

using Keys = std::set<std::string, std::less<>>;

/// Row for the entry under a key, if there is one; notes the key.
template <class Figure>
std::string rowOf(const json& part, std::string_view words, const Figure& figure, Keys& shown) {
    const std::string key(figure.key);
    shown.insert(key);
    const auto value = numberIn(part, key.c_str());
    return value ? tableRow(escaped(words), valueText(figure, *value)) : std::string();
}

/// Rows of entries that only a newer program knows, named by their keys.
std::string furtherRows(const json& part, const Keys& shown) {
    std::string rows;
    if (!part.is_object()) return rows;
    for (const auto& [key, value] : part.items()) {
        if (!value.is_number() || shown.count(key) > 0) continue;
        const NamedUnit named = namedUnit(key);
        rows += tableRow(named.words, measure(value.get<double>(), named.unit));
    }
    return rows;
}

std::string weldRows(const json& weld) {
    Keys shown;
    std::string rows;
    for (const auto& figures : {stationFigures(), wholeWeldFigures()})
        for (const WeldFigure& figure : figures)
            rows += rowOf(weld, figure.pageWords(), figure, shown);
    return rows + furtherRows(weld, shown);
}

std::string arcRows(const json& arc) {
    Keys shown(kInFormula.begin(), kInFormula.end());
    std::string rows;
    for (const ArcFigure& figure : kArcFigures)
        rows += rowOf(arc, phraseOf("figure", std::string(figure.key) + ".name"), figure, shown);
    return rows + furtherRows(arc, shown);
}

std::string table(const std::string& rows) {
    return rows.empty() ? rows : "<table>\n" + rows + "</table>\n";
}

/// Formula with its numbers, so that a reader can repeat it.
std::string heatPart(const json& arc) {
    const auto heat = numberIn(arc, "heat_input_kj_mm"), k = numberIn(arc, "efficiency_en_1011_1");
    if (!heat) return {};
    std::string text = "<b>" + measure(heat, "kJ/mm") + "</b>";
    const auto volts = numberIn(arc, "mean_voltage_v"), amperes = numberIn(arc, "mean_current_a"),
               speed = numberIn(arc, "travel_speed_mm_s");
    if (k && volts && amperes && speed)
        text = phrase("page_figures.heat.formula", {{"heat", text},
                                                    {"k", PhraseNumber(*k, 1)},
                                                    {"voltage", PhraseNumber(*volts, 1)},
                                                    {"current", PhraseNumber(*amperes)},
                                                    {"speed", measure(speed, "mm/s")}});
    return "<h2>" + phrase("page_figures.heat.heading") + "</h2>\n<p>" + text + "</p>\n<p class=\"quiet\">" +
           phrase("page_figures.heat.meaning") + "</p>\n";
}

} // namespace

std::string figurePart(const RunResults& results) {
    const json& arc = partIn(results.result, "arc");
    const std::string weld = weldRows(partIn(results.result, "weld"));
    const std::string burned = arcRows(arc);
    if (weld.empty() && burned.empty()) return {};
    return "<h2>" + phrase("page_figures.heading") + "</h2>\n<div class=\"columns\">\n" + table(weld) + table(burned) +
           "</div>\n" + heatPart(arc);
}

} // namespace meltpool
