// The part of the page about the verdict, with its places on the seam.
#include "app/report/page_parts.hpp"
#include "app/report/page_text.hpp"
#include "app/report/seam_strip.hpp"
#include "app/report/svg_text.hpp"
#include "core/base/words.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace meltpool {

namespace {

using nlohmann::json;

/// States in the order of the page.
constexpr std::array<std::string_view, 4> kStates{"fail", "not_resolved", "estimated", "pass"};

size_t rankOf(const json& item) {
    return static_cast<size_t>(std::find(kStates.begin(), kStates.end(), rawIn(item, "state")) - kStates.begin());
}

/// True for an imperfection that the metal never shows, such as a crack.
bool isNotSimulated(const json& item) {
    const WeldFigure* known = findImperfection(rawIn(item, "name"));
    return rawIn(item, "state") == "not_resolved" && known != nullptr && !known->isMeasured();
}

std::string stateText(const json& item) {
    const size_t rank = rankOf(item);
    if (rank == kStates.size()) return textIn(item, "state");
    if (isNotSimulated(item)) return phrase("page.state.not_simulated");
    if (kStates[rank] != "estimated") return phraseOf("page.state", kStates[rank]);
    return partIn(item, "beyond") == true ? phrase("page.state.likely", {{"rule", textIn(item, "rule")}})
                                          : phrase("page.state.unlikely");
}

std::string limitText(const json& item) {
    const std::string kind = rawIn(item, "limit_kind");
    const auto limit = numberIn(item, "limit");
    if (!limit) return kDash;
    if (kind == "not_permitted") return phrase("page.limit.not_permitted");
    return phrase(kind == "at_least" ? "page.limit.at_least" : "page.limit.at_most",
                  {{"limit", measure(limit, rawIn(item, "unit"))}});
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

/// Text of the places: "at 12.0 mm; 10.0 mm to 14.0 mm".
std::string whereText(const json& item) {
    const auto at = numberIn(item, "at_mm");
    if (!at || rawIn(item, "state") == "pass") return kDash;
    std::string text = phrase("page.where.place", {{"place", measure(at, "mm")}});
    for (const auto& [from, to] : stretchesOf(item))
        text += "; " + phrase("page.where.stretch", {{"from", measure(from, "mm")}, {"to", measure(to, "mm")}});
    return text;
}

/// Item of the verdict, with its letter on the strip; empty for one without a place there.
struct LetteredItem {
    const json* item = nullptr;
    std::string letter;
};

/// Items with letters; they point into `items`.
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

/// Range of the judged seam: the stations and half of a station's pitch beyond the outer ones.
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

/// Value with its uncertainty and the length that it is a mean of, as far as the result has them.
std::string valueText(const json& item) {
    const std::string unit = rawIn(item, "unit"), value = measure(numberIn(item, "value"), unit);
    const auto uncertainty = numberIn(item, "uncertainty"), length = numberIn(item, "mean_over_mm");
    if (!numberIn(item, "value") || uncertainty.value_or(0) <= 0 || rawIn(item, "state") == "estimated") return value;
    const std::string off = measure(uncertainty, unit);
    if (!length) return phrase("page.verdict.value", {{"value", value}, {"uncertainty", off}});
    return phrase("page.verdict.mean", {{"value", value}, {"uncertainty", off}, {"length", measure(length, "mm")}});
}

/// Sentence of an accepted weld on how much was judged and how much was not; empty for a result of an earlier version.
std::string nothingFound(const json& verdict) {
    const auto count = numberIn(verdict, "not_assessed");
    if (!count || partIn(verdict, "accepted") != true) return {};
    const long open = std::lround(*count);
    const long all = static_cast<long>(partIn(verdict, "items").size());
    return "<p>" +
           phrase("page.verdict.nothing", {{"passed", std::to_string(all - open)}, {"count", std::to_string(open)}}) +
           "</p>\n";
}

/// Sentence on a weld that is shorter than asked for; empty for another.
std::string unfinished(const json& verdict) {
    if (partIn(verdict, "complete") != false) return {};
    return "<p>" +
           phrase("page.verdict.unfinished", {{"judged", measure(numberIn(verdict, "judged_mm"), "mm")},
                                              {"asked", measure(numberIn(verdict, "asked_mm"), "mm")}}) +
           "</p>\n";
}

/// Sentence on how a failed imperfection is measured; empty for most.
std::string noteOf(const json& item) {
    const WeldFigure* known = findImperfection(rawIn(item, "name"));
    if (rawIn(item, "state") != "fail" || known == nullptr || known->note().empty()) return {};
    return "<br><span class=\"quiet\">" + escaped(std::string(known->note())) + "</span>";
}

std::string itemRow(const LetteredItem& each) {
    const json& item = *each.item;
    return "<tr><td>" + each.letter + "</td><td>" + escaped(imperfectionName(rawIn(item, "name"))) + noteOf(item) +
           "</td>" + numberCell(valueText(item)) + numberCell(limitText(item)) + "<td>" + whereText(item) +
           "</td><td class=\"" + textIn(item, "state") + "\">" + stateText(item) + "</td></tr>\n";
}

/// List of likely causes and remedies, with the command that tries a remedy where it appears first; empty if no item
/// has one.
std::string curesOf(const std::vector<LetteredItem>& items) {
    std::string html;
    std::set<std::string> tried;
    for (const LetteredItem& each : items) {
        const std::string cure = textIn(*each.item, "cure"), wish = textIn(*each.item, "try");
        if (cure.empty()) continue;
        html += "<li>" + cure;
        if (!wish.empty() && tried.insert(wish).second)
            html += " <span class=\"quiet\">" + phrase("page.verdict.try", {{"what_if", wish}}) + "</span>";
        html += "</li>\n";
    }
    if (html.empty()) return html;
    return "<p><b>" + phrase("cure.heading") + "</b></p>\n<ol>\n" + html + "</ol>\n";
}

} // namespace

std::string verdictPart(const RunResults& results) {
    const json& verdict = partIn(results.result, "verdict");
    if (!verdict.is_object())
        return partIn(results.result, "weld").is_object()
                   ? "<p class=\"quiet\">" + phrase("page.verdict.no_standard") + "</p>\n"
                   : std::string();
    const bool accepted = partIn(verdict, "accepted") == true;
    const std::string word = accepted ? "<span class=\"pass\">" + phrase("page.verdict.accepted") + "</span>"
                                      : "<span class=\"fail\">" + phrase("page.verdict.not_accepted") + "</span>";
    std::string html = "<h2>" +
                       phrase("page.verdict.heading", {{"standard", textIn(verdict, "standard")},
                                                       {"level", textIn(verdict, "level")},
                                                       {"edition", textIn(verdict, "edition")},
                                                       {"verdict", word}}) +
                       "</h2>\n";
    const std::vector<LetteredItem> items = lettered(partIn(verdict, "items"));
    html += unfinished(verdict) + nothingFound(verdict) + curesOf(items) + stripOf(results, items);
    html += "<table><thead><tr><th></th>" +
            headCells({"page.verdict.column.imperfection", "page.verdict.column.value", "page.verdict.column.limit",
                       "page.verdict.column.where", "page.verdict.column.verdict"}) +
            "</tr></thead>\n<tbody>\n";
    for (const LetteredItem& each : items)
        html += itemRow(each);
    return html + "</tbody></table>\n<p class=\"quiet\">" + phrase("page.verdict.legend", {{"unit", unitName("mm")}}) +
           "</p>\n";
}

} // namespace meltpool
