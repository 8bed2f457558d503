// The controls of a lesson's demonstration: pause, time, and the way to one's own attempt.
#include "app/ui/panels.hpp"

#include <algorithm>

namespace meltpool::ui {

namespace {

/// The time as a slider; the torch follows it.
void timeSlider(Context& context, Demonstration& demonstration) {
    auto time = static_cast<float>(demonstration.time());
    const Parameter parameter{"time", "Time", "s", &time, 0, demonstration.duration(), ""};
    static const DefaultTexts kNone;
    if (parameterControl(context, "demonstration", parameter, kNone)) demonstration.moveTo(static_cast<double>(time));
}

} // namespace

MenuRequest demonstrationPart(Context& context, LessonSession& session) {
    Demonstration& demonstration = session.demonstration();
    MenuRequest request = MenuRequest::none;
    strongText(context, "Demonstration");
    timeSlider(context, demonstration);
    ButtonRow row(context);
    if (row.add("demonstration.play", demonstration.playing() ? "Pause" : "Play", ButtonKind::plain, 76,
                "Stops the torch, or lets it go on (Space)"))
        demonstration.toggle();
    if (row.add("demonstration.again", "From the start", ButtonKind::plain, 120, "The torch and the metal"))
        demonstration.again();
    if (row.add("demonstration.weld", "Weld it yourself", ButtonKind::main, 140,
                "The metal as it was at first, and your torch (Enter, F5)"))
        request = MenuRequest::reset;
    if (demonstration.welds())
        quietText(context, "The expert's torch welds the metal. Pull the handle to bring the torch to any moment.");
    else
        quietText(context, session.run().torch().trigger > 0 ? "The torch alone; here it heats the metal."
                                                             : "The torch alone; here it is off.");
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
    const MenuRequest request = demonstrationPart(context, session);
    ImGui::End();
    return request;
}

} // namespace meltpool::ui
