// Draws the replay of a saved attempt: its time line with curves and events, pause, speed, and the result of its end.
#include "app/ui/curves.hpp"
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool::ui {

namespace {

constexpr float kChartHeight = 104, kLowChartHeight = 86; ///< points
constexpr float kLowWindow = 650;                         ///< points
constexpr double kSkippedShown = 3;                       ///< s of playing in which the skipped time is shown
constexpr float kSidePadding = 16;                        ///< points
constexpr float kWide = 700;                              ///< points that two columns need
constexpr ImU32 kFaultTint = IM_COL32(255, 138, 120, 255);

/// Draws the time as a slider; the metal follows it.
void timeSlider(Context& context, ReplayTimeline& line) {
    auto time = static_cast<float>(line.target());
    const Parameter parameter{"time",          phrase("replay.time"),        "s", &time, 0,
                              line.duration(), phrase("replay.tooltip.time")};
    static const DefaultTexts kNone;
    if (parameterControl(context, "replay", parameter, kNone)) line.seek(static_cast<double>(time));
}

void speedSlider(Context& context, ReplayTimeline& line) {
    auto speed = static_cast<float>(line.speed());
    const Parameter parameter{"speed",
                              phrase("replay.speed"),
                              "",
                              &speed,
                              ReplayTimeline::kSlowest,
                              ReplayTimeline::kFastest,
                              phrase("replay.tooltip.speed")};
    static const DefaultTexts kUsual{{"speed", "1"}};
    if (parameterControl(context, "replay", parameter, kUsual)) line.setSpeed(static_cast<double>(speed));
}

const TimelineMark* markAt(const AttemptReplay& replay, double time, double reach) {
    const TimelineMark* nearest = nullptr;
    for (const TimelineMark& mark : replay.marks())
        if (std::abs(mark.time - time) <= reach &&
            (nearest == nullptr || std::abs(mark.time - time) < std::abs(nearest->time - time)))
            nearest = &mark;
    return nearest;
}

ImU32 tintOf(const TimelineMark& mark) {
    return mark.fault ? kFaultTint : mark.redo ? colour::kWarning : colour::kQuiet;
}

/// Draws a quantity of the hand over the played part of the attempt's time, with the lesson's band.
CurveAnswer overTime(Context& context, const LessonSession& session, TechniqueQuantity quantity,
                     const CurveTrack& track, std::string_view name) {
    const Lesson& lesson = session.lesson();
    const QuantityInfo& info = quantityInfo(quantity, traitsOf(lesson.process).distance);
    const TechniqueBand* band = lesson.technique ? lesson.technique->find(quantity) : nullptr;
    const double duration = session.activities().replay.line().duration();
    // Gaps that come from fast play are joined.
    constexpr double kJoined = 8.5;
    constexpr auto kPlaces = static_cast<double>(CurveTrack::kPlaces);
    const auto place = [&](size_t i) { return (static_cast<double>(i) + 0.5) / kPlaces * duration; };
    const auto value = [&](size_t i) { return static_cast<double>(track.values()[i]); };
    const std::array<CurveSeries, 1> series{{{track.values().size(), place, value, kJoined / kPlaces * duration}}};
    CurveChart chart{name,
                     info.words(),
                     info.unit,
                     "s",
                     {},
                     {0, duration},
                     lowerThan(context, kLowWindow) ? kLowChartHeight : kChartHeight};
    if (band != nullptr) chart.band = CurveBand{band->ideal, band->inner, band->outer};
    chart.cursor = session.activities().replay.line().time();
    return curveChart(context, chart, series);
}

/// Marks the current time and the events over a chart; a click moves the attempt to its time.
void marksOfTime(Context& context, AttemptReplay& replay, const CurveAnswer& chart) {
    if (!chart.drawn) return;
    ReplayTimeline& line = replay.line();
    for (const TimelineMark& mark : replay.marks())
        curveMark(context, chart.sheet, mark.time, tintOf(mark), mark.fault || mark.redo ? 1.6f : 1);
    curveMark(context, chart.sheet, line.time(), colour::kAccent, 2);
    if (chart.clicked) line.seek(chart.under);
    if (!chart.hovered) return;
    if (const TimelineMark* mark = markAt(replay, chart.under, line.duration() * 0.01)) tooltip(context, mark->text);
}

void speedOverTime(Context& context, LessonSession& session) {
    AttemptReplay& replay = session.activities().replay;
    if (!(replay.line().duration() > 0)) return;
    ImGui::PushFont(context.fonts.small);
    marksOfTime(context, replay,
                overTime(context, session, TechniqueQuantity::travelSpeed, replay.speed(), "replay.curve.speed"));
    ImGui::PopFont();
}

void distanceOverTime(Context& context, LessonSession& session) {
    AttemptReplay& replay = session.activities().replay;
    if (session.lesson().model != LessonModel::Weld || !(replay.line().duration() > 0)) return;
    ImGui::PushFont(context.fonts.small);
    marksOfTime(context, replay,
                overTime(context, session, TechniqueQuantity::distance, replay.distance(), "replay.curve.distance"));
    ImGui::PopFont();
}

/// Describes the replay's current state.
ShortText stateText(const LessonSession& session) {
    const AttemptReplay& replay = session.activities().replay;
    const ReplayTimeline& line = replay.line();
    ShortText text;
    if (line.seeking()) {
        appendPhrase(text, "replay.state.seeking",
                     {{"seconds", PhraseNumber(line.target(), 1)}, {"share", PhraseNumber(100 * line.progress())}});
        return text;
    }
    if (line.start() > 0 && line.time() >= line.start() && line.time() < line.start() + kSkippedShown) {
        appendPhrase(text, "replay.state.skipped", {{"seconds", PhraseNumber(line.start(), 1)}});
        return text;
    }
    constexpr double kKeepsUp = 0.95;
    const double speed = line.speed() * session.run().clock().speed();
    if (line.playing() && speed < kKeepsUp * line.speed()) {
        appendPhrase(text, "replay.state.slow",
                     {{"speed", PhraseNumber(speed, 2)}, {"asked", PhraseNumber(line.speed(), 2)}});
        return text;
    }
    if (replay.comparison()) return ShortText(std::string_view(replay.comparison()->text));
    if (!replay.momentsRefused().empty()) return ShortText(std::string_view(replay.momentsRefused()));
    return ShortText(phrase("replay.state.welds"));
}

MenuRequest replayButtons(Context& context, ReplayTimeline& line) {
    MenuRequest request = MenuRequest::none;
    ButtonRow row(context);
    if (row.add("replay.play", phrase(line.playing() ? "replay.button.pause" : "replay.button.play").c_str(),
                ButtonKind::plain, 76, phrase("replay.tooltip.play").c_str()))
        line.toggle();
    if (row.add("replay.back", phrase("replay.button.back").c_str(), ButtonKind::plain, 52,
                phrase("replay.tooltip.back").c_str()))
        line.seek(line.target() - ReplayTimeline::kKeyStep);
    if (row.add("replay.on", phrase("replay.button.on").c_str(), ButtonKind::plain, 52,
                phrase("replay.tooltip.on").c_str()))
        line.seek(line.target() + ReplayTimeline::kKeyStep);
    if (row.add("replay.start", phrase("replay.button.start").c_str(), ButtonKind::plain, 116)) line.seek(line.start());
    if (row.add("replay.weld", phrase("replay.button.weld").c_str(), ButtonKind::main, 136,
                phrase("replay.tooltip.weld").c_str()))
        request = MenuRequest::reset;
    return request;
}

/// Draws time next to speed, the curves next to each other, and the buttons: low, so that the metal above stays in
/// view.
MenuRequest wideRows(Context& context, LessonSession& session) {
    ReplayTimeline& line = session.activities().replay.line();
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {context.points(10), ImGui::GetStyle().CellPadding.y});
    const bool open = ImGui::BeginTable("replay.wide", 2, ImGuiTableFlags_SizingStretchSame);
    ImGui::PopStyleVar();
    if (!open) return MenuRequest::none;
    ImGui::TableNextColumn();
    timeSlider(context, line);
    ImGui::TableNextColumn();
    speedSlider(context, line);
    ImGui::TableNextColumn();
    speedOverTime(context, session);
    ImGui::TableNextColumn();
    distanceOverTime(context, session);
    ImGui::EndTable();
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const MenuRequest request = replayButtons(context, line);
    const ShortText state = stateText(session);
    ImGui::PushFont(context.fonts.small);
    const float words = ImGui::CalcTextSize(state.c_str()).x;
    ImGui::PopFont();
    if (ImGui::GetItemRectMax().x + context.points(14) + words <= right) {
        ImGui::SameLine(0, context.points(14));
        ImGui::AlignTextToFramePadding();
    }
    quietText(context, state);
    return request;
}

} // namespace

MenuRequest replayPart(Context& context, LessonSession& session) {
    ReplayTimeline& line = session.activities().replay.line();
    if (ImGui::GetContentRegionAvail().x >= context.points(kWide)) return wideRows(context, session);
    strongText(context, phrase("replay.heading"));
    timeSlider(context, line);
    const MenuRequest request = replayButtons(context, line);
    quietText(context, stateText(session));
    speedOverTime(context, session);
    distanceOverTime(context, session);
    speedSlider(context, line);
    return request;
}

MenuRequest replayBar(Context& context, LessonSession& session) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float room = screen.x - context.points(20);
    const bool wide = room >= context.points(kWide + 2 * kSidePadding);
    const float width = wide ? std::min(context.points(1400), room) : std::min(context.points(500), room);
    ImGui::SetNextWindowPos({screen.x / 2, screen.y - barHeight(context) - context.points(10)}, ImGuiCond_Always,
                            {0.5f, 1});
    // More would cover the weld; the rest is reached by scrolling.
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(0.45f * screen.y, context.points(90))});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.points(kSidePadding), context.points(8)});
    ImGui::Begin("replay", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    noteWindow(context, "replay");
    const MenuRequest request = replayPart(context, session);
    context.playHeight = ImGui::GetWindowHeight();
    ImGui::End();
    return request;
}

} // namespace meltpool::ui
