// Draws two attempts next to each other: the steps to the comparison, the difference in words, figures and curves of
// both.
#include "app/ui/curves.hpp"
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"
#include "core/weld/gauge/weld_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool::ui {

namespace {

constexpr std::array<ImU32, 2> kTints{kFirstTint, kCurveTint};

/// Right ends of the three columns of figures, as shares of the width.
constexpr std::array<float, 3> kColumns{0.6f, 0.8f, 1};

void tinted(std::string_view text, ImU32 tint) {
    ImGui::PushStyleColor(ImGuiCol_Text, tint);
    wrappedText(text);
    ImGui::PopStyleColor();
}

/// Draws one line of a table, each figure at the right of its column; too wide ones have a line of their own.
void tableLine(std::string_view name, const std::array<std::string_view, 3>& figures,
               const std::array<ImU32, 3>& tints) {
    const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(name.data(), name.data() + name.size());
    float used = left + ImGui::CalcTextSize(name.data(), name.data() + name.size()).x;
    for (size_t i = 0; i < figures.size(); ++i) {
        const std::string_view text = figures[i];
        if (text.empty()) continue;
        const float wide = ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
        const float at = std::max(left, left + width * kColumns[i] - wide);
        if (at >= used) ImGui::SameLine();
        ImGui::SetCursorPosX(at);
        ImGui::PushStyleColor(ImGuiCol_Text, tints[i]);
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
        ImGui::PopStyleColor();
        used = at + wide;
    }
}

void figuresOfBoth(Context& context, const ComparisonRows& rows) {
    for (const ComparedSection& section : rows.sections) {
        if (!namedHeading(context, "comparison", section.name, section.title)) continue;
        ImGui::PushFont(context.fonts.small);
        tableLine("",
                  {phrase("comparison.column.first"), phrase("comparison.column.second"),
                   phrase("comparison.column.difference")},
                  {kTints[0], kTints[1], colour::kQuiet});
        for (const ComparedRow& row : section.rows)
            tableLine(row.name, {row.first, row.second, row.difference},
                      {colour::kText, colour::kText, colour::kWarning});
        ImGui::PopFont();
    }
}

/// Draws a quantity of the hand in both attempts, over mm of seam.
void handOfBoth(Context& context, const AttemptComparison& comparison, TechniqueQuantity quantity) {
    const Judgement &first = comparison.attempt(0)->judgement, &second = comparison.attempt(1)->judgement;
    const QuantityInfo& info = quantityInfo(quantity, first.distance);
    const TechniqueBand* band = comparison.bands() == nullptr ? nullptr : comparison.bands()->find(quantity);
    const auto placeIn = [](const Judgement& judgement, size_t i) { return judgement.seam[i].place * 1e3; };
    const auto valueIn = [&](const Judgement& judgement, size_t i) {
        return judgement.seam[i].values[quantity] * info.perSi;
    };
    const auto firstPlace = [&](size_t i) { return placeIn(first, i); };
    const auto firstValue = [&](size_t i) { return valueIn(first, i); };
    const auto secondPlace = [&](size_t i) { return placeIn(second, i); };
    const auto secondValue = [&](size_t i) { return valueIn(second, i); };
    constexpr double kGap = 1.5; // mm without arc that break a line
    const std::array<CurveSeries, 2> both{{{first.seam.size(), firstPlace, firstValue, kGap, kTints[0]},
                                           {second.seam.size(), secondPlace, secondValue, kGap, kTints[1]}}};
    const ShortText name{"comparison.curve.", info.column};
    CurveChart chart{name, info.words(), info.unit, "mm", {}};
    if (band != nullptr) chart.band = CurveBand{band->ideal, band->inner, band->outer};
    curveChart(context, chart, both);
}

/// Draws a figure of the weld at the stations of both, over mm of seam.
void weldOfBoth(Context& context, const AttemptComparison& comparison, const ComparedFigure& figure,
                const WeldFigure& row) {
    const auto &first = comparison.attempt(0)->judgement.weld, &second = comparison.attempt(1)->judgement.weld;
    if (!first || !second) return;
    const auto placeIn = [](const WeldMeasures& weld, size_t i) { return weld.stations[i].place * 1e3; };
    const auto valueIn = [&](const WeldMeasures& weld, size_t i) {
        const WeldStation::Value& value = weld.stations[i].*row.member;
        return value ? *value / row.inSi() : std::nan("");
    };
    const auto firstPlace = [&](size_t i) { return placeIn(*first, i); };
    const auto firstValue = [&](size_t i) { return valueIn(*first, i); };
    const auto secondPlace = [&](size_t i) { return placeIn(*second, i); };
    const auto secondValue = [&](size_t i) { return valueIn(*second, i); };
    constexpr double kPitches = 1.5; // pitches of the stations: closer ones are joined
    const std::array<CurveSeries, 2> both{
        {{first->stations.size(), firstPlace, firstValue, kPitches * first->pitch * 1e3, kTints[0]},
         {second->stations.size(), secondPlace, secondValue, kPitches * second->pitch * 1e3, kTints[1]}}};
    const ShortText name{"comparison.curve.", figure.key};
    curveChart(context, {name, figure.name, figure.unit, "mm", {}}, both);
}

void curvesOfBoth(Context& context, const AttemptComparison& comparison) {
    if (!groupHeading(context, "comparison", "Along the seam")) return;
    ImGui::PushFont(context.fonts.small);
    if (comparison.bands() != nullptr)
        for (const TechniqueBand& band : comparison.bands()->bands)
            handOfBoth(context, comparison, band.quantity);
    else
        handOfBoth(context, comparison, TechniqueQuantity::travelSpeed);
    for (const FigurePair& pair : comparison.comparison()->pairs)
        if (const WeldFigure* row = findStationFigure(pair.figure.key); row != nullptr && pair.isDrawn())
            weldOfBoth(context, comparison, pair.figure, *row);
    ImGui::PopFont();
}

void wayPart(Context& context, const AttemptComparison& comparison) {
    ShortText text;
    appendPhrase(text, comparison.current() == 0 ? "comparison.welding.first" : "comparison.welding.second",
                 {{"share", PhraseNumber(100 * comparison.progress())}});
    ImGui::TextUnformatted(text.c_str());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = context.points(8);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    fillRounded(draw, low, {low.x + width, low.y + height}, colour::kTrack, context.points(3));
    const float done = width * static_cast<float>(comparison.progress());
    fillRounded(draw, low, {low.x + done, low.y + height}, colour::kAccent, context.points(3));
    ImGui::Dummy({width, height});
    quietText(context, phrase("comparison.welding.note"));
}

} // namespace

void comparisonPart(Context& context, Activities& activities) {
    const AttemptComparison& comparison = activities.comparison;
    const std::string& leave = phrase(comparison.welding() ? "comparison.button.stop" : "comparison.button.back");
    const bool back =
        button(context, "comparison.back", leave.c_str(), ButtonKind::plain, comparison.welding() ? 80 : 160);
    ImGui::SameLine();
    strongText(context, comparison.lesson());
    for (size_t i = 0; i < kTints.size(); ++i) {
        ShortText attempt;
        appendPhrase(attempt, i == 0 ? "comparison.attempt.first" : "comparison.attempt.second",
                     {{"detail", comparison.side(i).detail}});
        tinted(attempt, kTints[i]);
    }
    ImGui::Dummy({0, context.points(4)});
    if (!comparison.fault().empty()) {
        tinted(comparison.fault(), colour::kWarning);
    } else if (comparison.welding()) {
        wayPart(context, comparison);
    } else if (comparison.rows()) {
        ImGui::PushFont(context.fonts.strong);
        tinted(comparison.rows()->words, colour::kText);
        ImGui::PopFont();
        markItem(context, "comparison.words");
        for (const std::string& note : comparison.rows()->notes)
            quietText(context, note);
        figuresOfBoth(context, *comparison.rows());
        curvesOfBoth(context, comparison);
    }
    if (back) activities.endComparison();
}

} // namespace meltpool::ui
