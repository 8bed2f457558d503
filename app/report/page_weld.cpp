// The part of the page that is about the verdict, with its places on the seam.
#include "app/report/page_parts.hpp"
#include "app/report/page_text.hpp"
#include "app/report/seam_strip.hpp"
#include "app/report/svg_text.hpp"
#include "core/weld/gauge/weld_figures.hpp"

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
    return "<tr><td>" + each.letter + "</td><td>" + escaped(imperfectionName(rawIn(item, "name"))) + "</td>" +
           numberCell(measure(numberIn(item, "value"), unit)) + numberCell(limitText(item)) + "<td>" + whereText(item) +
           "</td><td class=\"" + textIn(item, "state") + "\">" + stateText(item) + "</td></tr>\n";
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

} // namespace meltpool
