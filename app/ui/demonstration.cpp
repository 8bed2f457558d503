// Draws the controls of a lesson's demonstration: pause, time, and the button for one's own attempt.
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

#include <algorithm>

namespace meltpool::ui {

namespace {

/// Draws the time as a slider; the torch follows it.
void timeSlider(Context& context, Demonstration& demonstration) {
    auto time = static_cast<float>(demonstration.time());
    const Parameter parameter{"time", phrase("demonstration.time"), "s", &time, 0, demonstration.duration(), ""};
    static const DefaultTexts kNone;
    if (parameterControl(context, "demonstration", parameter, kNone)) demonstration.moveTo(static_cast<double>(time));
}

} // namespace

MenuRequest demonstrationPart(Context& context, LessonSession& session) {
    Demonstration& demonstration = session.activities().demonstration;
    MenuRequest request = MenuRequest::none;
    strongText(context, phrase("demonstration.heading"));
    timeSlider(context, demonstration);
    ButtonRow row(context);
    const std::string& play =
        phrase(demonstration.playing() ? "demonstration.button.pause" : "demonstration.button.play");
    if (row.add("demonstration.play", play.c_str(), ButtonKind::plain, 76,
                phrase("demonstration.tooltip.play").c_str()))
        demonstration.toggle();
    if (row.add("demonstration.again", phrase("demonstration.button.again").c_str(), ButtonKind::plain, 120,
                phrase("demonstration.tooltip.again").c_str()))
        demonstration.again();
    if (row.add("demonstration.weld", phrase("demonstration.button.weld").c_str(), ButtonKind::main, 140,
                phrase("demonstration.tooltip.weld").c_str()))
        request = MenuRequest::reset;
    if (demonstration.welds())
        quietText(context, phrase("demonstration.note.welds"));
    else
        quietText(context,
                  phrase(session.run().torch().trigger > 0 ? "demonstration.note.heats" : "demonstration.note.off"));
    return request;
}

MenuRequest demonstrationBar(Context& context, LessonSession& session, float left, float right) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = std::min(context.points(400), screen.x - context.points(20));
    if (screen.x - left - right < width + context.points(20)) left = right = 0;
    ImGui::SetNextWindowPos({(left + screen.x - right) / 2, screen.y - barHeight(context) - context.points(10)},
                            ImGuiCond_Always, {0.5f, 1});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - 2 * barHeight(context) - context.points(20)});
    ImGui::Begin("demonstration", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    noteWindow(context, "demonstration");
    const MenuRequest request = demonstrationPart(context, session);
    context.playHeight = ImGui::GetWindowHeight();
    ImGui::End();
    return request;
}

} // namespace meltpool::ui
