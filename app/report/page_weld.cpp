// The part of the page that is about the weld: verdict with its places, figures, heat input.
#include "app/report/drawings/seam_strip.hpp"
#include "app/report/drawings/svg_text.hpp"
#include "app/report/page_parts.hpp"
#include "app/report/page_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

using nlohmann::json;

/// States in the order in which the page shows them, and their words.
constexpr std::array<std::pair<std::string_view, const char*>, 4> kStates{
    {{"fail", "FAILS"}, {"not_resolved", "not resolved"}, {"estimated", "estimated"}, {"pass", "passes"}}};

size_t rankOf(const json& item) {
    const std::string state = rawIn(item, "state");
    for (size_t i = 0; i < kStates.size(); ++i)
        if (kStates[i].first == state) return i;
    return kStates.size();
}

std::string stateText(const json& item) {
    const size_t rank = rankOf(item);
    if (rank == kStates.size()) return textIn(item, "state");
    std::string text = kStates[rank].second;
    if (rawIn(item, "state") == "estimated") {
        text += partIn(item, "beyond") == true ? ": likely" : ": unlikely";
        if (partIn(item, "beyond") == true) text += ". " + textIn(item, "rule");
    }
    return text;
}

std::string limitText(const json& item) {
    const std::string kind = rawIn(item, "limit_kind");
    const auto limit = numberIn(item, "limit");
    if (!limit) return kDash;
    if (kind == "not_permitted") return "none allowed";
    return (kind == "at_least" ? "at least " : "at most ") + measure(limit, rawIn(item, "unit"));
}

std::vector<std::pair<double, double>> stretchesOf(const json& item) {
    std::vector<std::pair<double, double>> stretches;
    const json& all = partIn(item, "stretches_mm");
    if (!all.is_array()) return stretches;
    for (const json& each : all)
        if (each.is_array() && each.size() == 2 && each[0].is_number() && each[1].is_number())
            stretches.emplace_back(each[0].get<double>(), each[1].get<double>());
    return stretches;
}

/// "at 12.0 mm; 10.0 mm to 14.0 mm"
std::string whereText(const json& item) {
    const auto at = numberIn(item, "at_mm");
    if (!at || rawIn(item, "state") == "pass") return kDash;
    std::string text = "at " + measure(at, "mm");
    for (const auto& [from, to] : stretchesOf(item))
        text += "; " + measure(from, "mm") + " to " + measure(to, "mm");
    return text;
}

/// An item of the verdict, with the letter that it has on the strip; empty for one without a place there.
struct LetteredItem {
    const json* item = nullptr;
    std::string letter;
};

/// They point into `items`.
std::vector<LetteredItem> lettered(const json& items) {
    std::vector<LetteredItem> all;
    if (!items.is_array()) return all;
    for (const json& item : items)
        if (item.is_object()) all.push_back({&item, {}});
    std::stable_sort(all.begin(), all.end(),
                     [](const LetteredItem& a, const LetteredItem& b) { return rankOf(*a.item) < rankOf(*b.item); });
    size_t number = 0;
    for (LetteredItem& each : all)
        if (numberIn(*each.item, "at_mm") && rawIn(*each.item, "state") != "pass") each.letter = markLetter(number++);
    return all;
}

/// The judged seam: the stations and half of what each stands for beyond the outer ones.
std::pair<double, double> seamOf(const RunResults& results) {
    const std::vector<double> places = results.weld.column("place_mm");
    if (places.empty()) return {0, 0};
    const double half = numberIn(partIn(results.result, "weld"), "pitch_mm").value_or(0) / 2;
    return {places.front() - half, places.back() + half};
}

std::string stripOf(const RunResults& results, const std::vector<LetteredItem>& items) {
    std::vector<SeamMark> marks;
    for (const LetteredItem& each : items) {
        if (each.letter.empty()) continue;
        marks.push_back({each.letter, rawIn(*each.item, "state") == "fail", numberIn(*each.item, "at_mm").value_or(0),
                         stretchesOf(*each.item)});
    }
    const auto [from, to] = seamOf(results);
    return seamStrip(from, to, marks);
}

std::string itemRow(const LetteredItem& each) {
    const json& item = *each.item;
    const std::string unit = rawIn(item, "unit");
    return "<tr><td>" + each.letter + "</td><td>" + namedUnit(rawIn(item, "name")).words + "</td>" +
           numberCell(measure(numberIn(item, "value"), unit)) + numberCell(limitText(item)) + "<td>" + whereText(item) +
           "</td><td class=\"" + textIn(item, "state") + "\">" + stateText(item) + "</td></tr>\n";
}

/// Names of entries that have words of their own, or that stand elsewhere on the page.
std::string figureRow(const std::string& key, double value) {
    if (key == "mean_current_a") return tableRow("mean current", rounded(value, 0) + " A");
    if (key == "mean_voltage_v") return tableRow("mean voltage", rounded(value, 1) + " V");
    if (key == "energy_kj") return tableRow("energy of the arc", rounded(value, 1) + " kJ");
    if (key == "seconds") return tableRow("time of the arc", rounded(value, 1) + " s");
    if (key == "seam_mm") return tableRow("seam on which it burned", measure(value, "mm"));
    if (key == "pitch_mm") return tableRow("seam that a station stands for", measure(value, "mm"));
    if (key == "spacing_mm") return tableRow("particles lie apart", measure(value, "mm"));
    if (key == "t85_s")
        return tableRow("cooling from 800 to 500 \xC2\xB0"
                        "C",
                        measure(value, "s"));
    if (key == "stations") return tableRow("stations", rounded(value, 0));
    if (key == "efficiency_en_1011_1" || key == "heat_input_kj_mm") return {};
    const NamedUnit figure = namedUnit(key);
    return tableRow(figure.words, measure(value, figure.unit));
}

std::string figuresOf(const json& part) {
    std::string rows;
    if (!part.is_object()) return rows;
    for (const auto& [key, value] : part.items())
        if (value.is_number()) rows += figureRow(key, value.get<double>());
    return rows;
}

std::string table(const std::string& rows) {
    return rows.empty() ? rows : "<table>\n" + rows + "</table>\n";
}

/// The formula with its numbers, so that a reader can repeat it.
std::string heatPart(const json& arc) {
    const auto heat = numberIn(arc, "heat_input_kj_mm"), k = numberIn(arc, "efficiency_en_1011_1");
    if (!heat) return {};
    std::string html = "<h2>Heat input by EN 1011-1</h2>\n<p><b>" + measure(heat, "kJ/mm") + "</b>";
    const auto volts = numberIn(arc, "mean_voltage_v"), amperes = numberIn(arc, "mean_current_a"),
               speed = numberIn(arc, "travel_speed_mm_s");
    if (k && volts && amperes && speed)
        html += " = k \xC2\xB7 U \xC2\xB7 I / v = " + rounded(*k, 1) + " \xC2\xB7 " + rounded(*volts, 1) +
                " V \xC2\xB7 " + rounded(*amperes, 0) + " A / (" + measure(speed, "mm/s") + ")";
    html +=
        "</p>\n<p class=\"quiet\">k is the thermal efficiency by EN 1011-1: 0.8 for GMAW and covered electrodes, 0.6 "
        "for GTAW. U and I are means while the arc burned, v the seam on which it burned over that time.</p>\n";
    return html;
}

} // namespace

std::string verdictPart(const RunResults& results) {
    const json& verdict = partIn(results.result, "verdict");
    if (!verdict.is_object())
        return partIn(results.result, "weld").is_object()
                   ? "<p class=\"quiet\">This lesson names no standard: the weld is measured but not judged.</p>\n"
                   : std::string();
    const bool accepted = partIn(verdict, "accepted") == true;
    std::string html = "<h2>The weld by " + textIn(verdict, "standard") + " " + textIn(verdict, "level") + " (" +
                       textIn(verdict, "edition") + "): <span class=\"" +
                       (accepted ? "pass\">accepted" : "fail\">not accepted") + "</span></h2>\n";
    const std::vector<LetteredItem> items = lettered(partIn(verdict, "items"));
    html += stripOf(results, items);
    html += "<table><thead><tr><th></th><th>imperfection</th><th>value</th><th>limit</th><th>where</th>"
            "<th>verdict</th></tr></thead>\n<tbody>\n";
    for (const LetteredItem& each : items)
        html += itemRow(each);
    return html +
           "</tbody></table>\n<p class=\"quiet\">Letters: on the strip, at the worst place; hatched: where it "
           "fails. Not resolved: finer than the particles, or nothing that the metal contains. Estimated: from the "
           "technique, in mm of weld. Neither passes nor fails.</p>\n";
}

std::string figurePart(const RunResults& results) {
    const json& arc = partIn(results.result, "arc");
    const std::string weld = figuresOf(partIn(results.result, "weld")), burned = figuresOf(arc);
    if (weld.empty() && burned.empty()) return {};
    return "<h2>The weld in figures</h2>\n<div class=\"columns\">\n" + table(weld) + table(burned) + "</div>\n" +
           heatPart(arc);
}

} // namespace meltpool
