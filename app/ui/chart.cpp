// Draws a row of a maker's chart for the lesson's plates and machine, with the button that takes its values.
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

namespace meltpool::ui {

namespace {

/// Draws a label at the left and its value at the right; below the label where the line is too short for both.
void figureLine(Context& context, const ShownChartRow::Value& figure) {
    const float left = ImGui::GetCursorPosX(), right = left + ImGui::GetContentRegionAvail().x;
    const float width = ImGui::CalcTextSize(figure.text.c_str()).x;
    ImGui::PushStyleColor(ImGuiCol_Text, colour::kQuiet);
    ImGui::TextUnformatted(figure.label.c_str());
    ImGui::PopStyleColor();
    if (left + ImGui::GetItemRectSize().x + context.points(8) + width <= right) ImGui::SameLine();
    ImGui::SetCursorPosX(std::max(left, right - width));
    ImGui::TextUnformatted(figure.text.c_str());
}

} // namespace

void chartPart(Context& context, ChartValues& chart) {
    if (!chart.applies()) return;
    if (!groupHeading(context, "simulation", "Maker's chart")) return;
    chart.update();
    if (!chart.notice().empty()) quietText(context, chart.notice());
    if (chart.rows().empty()) return;
    const ShownChartRow& row = chart.shown();
    strongText(context, row.title);
    for (const ShownChartRow::Value& figure : row.figures)
        figureLine(context, figure);
    quietText(context, row.source);
    for (const std::string& note : row.notes)
        quietText(context, note);
    const bool takes = chart.canTake();
    if (takes && chart.beyondLimits()) quietText(context, phrase("chart.note.limits"));
    ButtonRow buttons(context);
    if (takes && buttons.add("simulation.chart_take", phrase("chart.take").c_str(), ButtonKind::plain, 0,
                             phrase("chart.take_tip").c_str()))
        chart.take();
    if (chart.rows().size() < 2) return;
    ShortText next;
    appendPhrase(next, "chart.next",
                 {{"number", PhraseNumber(static_cast<double>(chart.shownIndex() + 1))},
                  {"count", PhraseNumber(static_cast<double>(chart.rows().size()))}});
    if (buttons.add("simulation.chart_next", next.c_str(), ButtonKind::plain, 0, phrase("chart.next_tip").c_str()))
        chart.showNext();
}

} // namespace meltpool::ui
