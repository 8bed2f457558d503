#include "app/activities/comparison_rows.hpp"

#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace meltpool {

namespace {

constexpr const char* kNone = "-";

std::string fixed(double value, int decimals) {
    return std::string(PhraseNumber(value, decimals));
}

std::string withUnit(const std::string& number, std::string_view unit) {
    if (unit == "%" || unit == "\xC2\xB0") return number + std::string(unit);
    const std::string_view shown = shownUnit(unit).name;
    return std::string(inShownUnit(number, unit)) + " " + (shown == "mm2" ? "mm\xC2\xB2" : std::string(shown));
}

std::string withSign(double value, int decimals) {
    return std::string(PhraseNumber(value, decimals, true));
}

const std::string& verdictOf(const Judgement& judgement) {
    if (judgement.verdict)
        return phrase(judgement.verdict->accepted ? "compared.verdict.accepted" : "compared.verdict.not_accepted");
    const bool welded = judgement.weld && !judgement.weld->stations.empty();
    return phrase(welded ? "compared.verdict.not_judged" : "compared.verdict.no_weld");
}

/// List of failures: "overlap, undercut"; "nothing" for a verdict without any.
std::string failsOf(const Judgement& judgement) {
    if (!judgement.verdict) return kNone;
    std::string names;
    for (const VerdictItem& item : judgement.verdict->items) {
        if (item.state != VerdictState::fail) continue;
        if (!names.empty()) names += phrase("list.separator");
        names += imperfectionName(item.name);
    }
    return names.empty() ? phrase("compared.fails.nothing") : names;
}

/// Second of two texts of a row if they differ.
std::string other(const std::string& first, const std::string& second) {
    return first == second ? std::string() : phrase("compared.other");
}

std::string points(const std::optional<double>& value) {
    return value ? fixed(*value, 0) : kNone;
}

ComparedSection resultOf(const Judgement& first, const Judgement& second) {
    ComparedSection section{"verdict", phrase("compared.verdict.heading"), {}};
    const std::array<std::string, 2> verdicts{verdictOf(first), verdictOf(second)};
    section.rows.push_back(
        {phrase("compared.verdict.name"), verdicts[0], verdicts[1], other(verdicts[0], verdicts[1])});
    const std::array<std::string, 2> fails{failsOf(first), failsOf(second)};
    if (fails[0] != kNone || fails[1] != kNone)
        section.rows.push_back({phrase("compared.fails.name"), fails[0], fails[1], other(fails[0], fails[1])});
    return section;
}

ComparedSection scoresOf(const Comparison& comparison) {
    ComparedSection section{"points", phrase("compared.points"), {}};
    for (const ScorePair& pair : comparison.scores) {
        ComparedRow row{capitalised(pair.name), points(pair.first), points(pair.second), {}};
        if (pair.first && pair.second && std::abs(*pair.second - *pair.first) >= 1)
            row.difference = withSign(*pair.second - *pair.first, 0);
        section.rows.push_back(std::move(row));
    }
    return section;
}

ComparedSection groupOf(const Comparison& comparison, FigureGroup group, const char* name) {
    ComparedSection section{name, phraseOf("compared.group", name), {}};
    for (const FigurePair& pair : comparison.pairs) {
        if (pair.figure.group != group) continue;
        const auto shown = [&](double value) { return withUnit(fixed(value, pair.decimals()), pair.figure.unit); };
        ComparedRow row{capitalised(pair.figure.name), shown(pair.first), shown(pair.second), {}};
        if (pair.differs()) row.difference = withUnit(withSign(pair.difference(), pair.decimals()), pair.figure.unit);
        section.rows.push_back(std::move(row));
    }
    return section;
}

} // namespace

ComparisonRows comparisonRows(const Judgement& first, const Judgement& second, const Comparison& comparison) {
    ComparisonRows rows;
    rows.words = phrase("compared.words", {{"differences", comparisonText(comparison)}});
    if (comparison.halfSpacing > 0)
        rows.notes.push_back(
            phrase("compared.note.resolved", {{"length", PhraseNumber(comparison.halfSpacing * 1e3, 2)}}));
    rows.sections = {resultOf(first, second), scoresOf(comparison), groupOf(comparison, FigureGroup::weld, "weld"),
                     groupOf(comparison, FigureGroup::hand, "hand"), groupOf(comparison, FigureGroup::arc, "arc")};
    std::erase_if(rows.sections, [](const ComparedSection& section) { return section.rows.empty(); });
    return rows;
}

} // namespace meltpool
