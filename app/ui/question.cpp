// Draws the question that must be answered before the lesson continues.
#include "app/ui/panels.hpp"

#include <algorithm>
#include <string>

namespace meltpool::ui {

void questionPart(Context& context, Question& question) {
    wrappedText(question.text);
    ImGui::Dummy({0, context.points(6)});
    for (size_t i = 0; i < question.answers.size(); ++i) {
        const std::string place = "question." + std::to_string(i);
        const float width = ImGui::GetContentRegionAvail().x / context.scale;
        if (button(context, place, question.answers[i].c_str(), ButtonKind::plain, width))
            question.answered = static_cast<int>(i);
    }
}

void questionOverlay(Context& context, Question& question) {
    if (!question.asked()) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = std::min(context.points(520), screen.x - context.points(24));
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - context.points(16)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.points(28), context.points(24)});
    ImGui::SetNextWindowFocus();
    ImGui::Begin("question", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    questionPart(context, question);
    ImGui::End();
}

} // namespace meltpool::ui
