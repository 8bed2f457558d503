// Draws a lesson's first page: task, machine values, start; and the program's logo and backdrop.
#include "app/ui/panels.hpp"

#include "core/base/words.hpp"
#include "core/weld/workpiece/simulated_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace meltpool::ui {

namespace {

ImU32 mix(ImU32 a, ImU32 b, float share) {
    const ImVec4 x = ImGui::ColorConvertU32ToFloat4(a);
    const ImVec4 y = ImGui::ColorConvertU32ToFloat4(b);
    const auto channel = [share](float p, float q) { return p + (q - p) * share; };
    return ImGui::ColorConvertFloat4ToU32({channel(x.x, y.x), channel(x.y, y.y), channel(x.z, y.z), channel(x.w, y.w)});
}

/// Glow of the metal at a heat of 0..1: grey, red, orange, nearly white.
ImU32 glow(float heat, float shade) {
    constexpr std::array<ImU32, 5> kSteps{IM_COL32(150, 158, 170, 255), IM_COL32(160, 120, 110, 255),
                                          IM_COL32(226, 74, 22, 255), IM_COL32(255, 154, 48, 255),
                                          IM_COL32(255, 244, 205, 255)};
    const float at = std::clamp(heat, 0.0f, 1.0f) * 4;
    const auto low = std::min<size_t>(static_cast<size_t>(at), 3);
    const ImU32 bright = mix(kSteps[low], kSteps[low + 1], at - static_cast<float>(low));
    return mix(bright, IM_COL32(12, 14, 18, 255), (1 - shade) * (1 - heat));
}

constexpr int kCells = 10;
constexpr int kNodes = kCells + 1;

/// Holds the colours of a face, a fine lattice of nodes, by their distance from the hot corner.
class FaceColours {
  public:
    explicit FaceColours(float shade) {
        for (int i = 0; i < kNodes; ++i)
            for (int j = 0; j < kNodes; ++j) {
                const float s = static_cast<float>(i) / kCells;
                const float t = static_cast<float>(j) / kCells;
                nodes_[static_cast<size_t>(i * kNodes + j)] = glow(1.15f - 1.45f * std::sqrt(s * s + t * t), shade);
            }
    }
    ImU32 at(int i, int j) const { return nodes_[static_cast<size_t>(i * kNodes + j)]; }

  private:
    std::array<ImU32, size_t{kNodes} * kNodes> nodes_{};
};

/// Draws one face between the edge vectors u and v from the hot corner, which is nearest to the eye.
void drawFace(ImDrawList& draw, ImVec2 corner, ImVec2 u, ImVec2 v, const FaceColours& colours) {
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    draw.PrimReserve(6 * kCells * kCells, kNodes * kNodes);
    const auto first = static_cast<int>(draw._VtxCurrentIdx);
    for (int i = 0; i < kCells; ++i)
        for (int j = 0; j < kCells; ++j) {
            const int node = first + i * kNodes + j;
            for (const int k : {0, kNodes, kNodes + 1, 0, kNodes + 1, 1})
                draw.PrimWriteIdx(static_cast<ImDrawIdx>(node + k));
        }
    for (int i = 0; i < kNodes; ++i)
        for (int j = 0; j < kNodes; ++j) {
            const float s = static_cast<float>(i) / kCells;
            const float t = static_cast<float>(j) / kCells;
            draw.PrimWriteVtx({corner.x + u.x * s + v.x * t, corner.y + u.y * s + v.y * t}, white, colours.at(i, j));
        }
}

/// Draws a soft round glow.
void drawGlow(ImDrawList& draw, ImVec2 centre, float radius, ImU32 inner) {
    constexpr int kParts = 48;
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    const ImU32 outer = inner & ~IM_COL32_A_MASK;
    draw.PrimReserve(kParts * 3, kParts + 1);
    const auto first = static_cast<ImDrawIdx>(draw._VtxCurrentIdx);
    for (int i = 0; i < kParts; ++i) {
        draw.PrimWriteIdx(first);
        draw.PrimWriteIdx(static_cast<ImDrawIdx>(first + 1 + i));
        draw.PrimWriteIdx(static_cast<ImDrawIdx>(first + 1 + (i + 1) % kParts));
    }
    draw.PrimWriteVtx(centre, white, inner);
    for (int i = 0; i < kParts; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / kParts;
        draw.PrimWriteVtx({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)}, white, outer);
    }
}

/// Draws picture, title and task of the lesson, and the trainee's progress in it.
void introduction(Context& context, const Lesson& lesson, Home& home) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool narrow = narrowerThan(context, 480); // the words need the whole width
    const float height = context.points(92);
    float width = height;
    if (narrow) {
        width = 0;
    } else if (const GLuint picture = home.pictures.texture(lesson.listPicture); picture != 0) {
        width = height * 16 / 9;
        drawPicture(*ImGui::GetWindowDrawList(), picture, at, {at.x + width, at.y + height});
    } else {
        drawSign(*ImGui::GetWindowDrawList(), {at.x + height / 2, at.y + height / 2}, height);
    }
    if (width > 0) {
        ImGui::Dummy({width, height});
        ImGui::SameLine(0, context.points(22));
    }
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(0);
    strongText(context, lesson.title);
    ImGui::PopTextWrapPos();
    wrappedText(lesson.text.empty() ? phrase("start.free_task") : lesson.text);
    if (const std::string name = home.who.name(); !name.empty())
        quietText(context, phrase("persons.welder", {{"name", name}}));
    if (const CataloguedLesson* listed = home.find(lesson)) quietText(context, home.standing(*listed));
    ImGui::EndGroup();
}

/// Draws a parameter with its explanation below.
void explained(Context& context, const ParameterSection& section, const Parameter& parameter) {
    parameterControl(context, section, parameter);
    quietText(context, sentence(translatedNote(section.words, parameter)));
    ImGui::Dummy({0, context.points(3)});
}

/// Draws the section's values of the expert drawer, or all others.
void explainAll(Context& context, const ParameterSection& section, bool expert) {
    for (const Parameter& parameter : section.parameters)
        if (section.shows(parameter) && section.isExpert(parameter) == expert) explained(context, section, parameter);
}

/// Draws task and values, in an area that scrolls if the window is too small for all, so that the buttons below stay
/// visible. `room`: for all of the menu, pixels.
void taskAndValues(Context& context, LessonSession& session, Home& home, float room) {
    constexpr float kFoot = 150; // points of the buttons, until they are drawn
    const float foot = context.startFootHeight > 0 ? context.startFootHeight : context.points(kFoot);
    const float free = std::max(context.points(40), room - foot);
    const float height = std::min(context.startValuesHeight, free);
    beginPart("values", {0, height > 0 ? height : free});
    if (ImGui::IsWindowAppearing()) ImGui::SetScrollY(0); // another lesson's place may remain
    introduction(context, session.lesson(), home);
    ImGui::Dummy({0, context.points(6)});
    setupPart(context, session);
    context.startValuesHeight = ImGui::GetCursorPosY();
    ImGui::EndChild();
    markItem(context, "start.values");
}

/// Draws the buttons below the values.
MenuRequest startButtons(Context& context, bool demonstrated) {
    MenuRequest request = MenuRequest::none;
    const float half = (ImGui::GetContentRegionAvail().x / context.scale - 12) / 2;
    const float thick = lowerThan(context, 420) ? 6.0f : 11.0f;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {context.points(12), context.points(thick)});
    ButtonRow ways(context, 12);
    if (ways.add("start.start", phrase("start.start").c_str(), ButtonKind::main, half,
                 phrase("start.start_tip").c_str()))
        request = MenuRequest::start;
    if (ways.add("start.defaults", phrase("start.defaults").c_str(), ButtonKind::plain, half,
                 phrase("start.defaults_tip").c_str()))
        request = MenuRequest::startWithDefaults;
    ImGui::PopStyleVar();
    ButtonRow others(context, 12);
    ShortText note;
    appendPhrase(note, "start.home_tip", {{"key", context.key(Key::h)}});
    if (others.add("start.home", phrase("start.home").c_str(), ButtonKind::plain, half, note.c_str()))
        request = MenuRequest::home;
    if (demonstrated && others.add("start.demonstration", phrase("start.demonstration").c_str(), ButtonKind::plain,
                                   half, phrase("start.demonstration_tip").c_str()))
        request = MenuRequest::demonstrate;
    return request;
}

} // namespace

void drawSign(ImDrawList& draw, ImVec2 centre, float size) {
    const float half = size * 0.5f;
    const float wide = half * 0.866f;
    const ImVec2 near{centre.x, centre.y};
    static const FaceColours top(1.0f), left(0.62f), right(0.42f);
    drawFace(draw, near, {-wide, -half * 0.5f}, {wide, -half * 0.5f}, top);
    drawFace(draw, near, {-wide, -half * 0.5f}, {0, half}, left);
    drawFace(draw, near, {wide, -half * 0.5f}, {0, half}, right);
    // The lattices have hard edges; a soft outline smooths the silhouette.
    const std::array<ImVec2, 6> outline{{{near.x, near.y - half},
                                         {near.x + wide, near.y - half * 0.5f},
                                         {near.x + wide, near.y + half * 0.5f},
                                         {near.x, near.y + half},
                                         {near.x - wide, near.y + half * 0.5f},
                                         {near.x - wide, near.y - half * 0.5f}}};
    draw.AddPolyline(outline.data(), 6, IM_COL32(58, 63, 72, 255), ImDrawFlags_Closed, std::max(1.2f, size * 0.018f));
}

void drawBackdrop(float width, float height) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    constexpr ImU32 kTop = IM_COL32(17, 20, 27, 255);
    constexpr ImU32 kBottom = IM_COL32(34, 30, 32, 255);
    draw.AddRectFilledMultiColor({0, 0}, {width, height}, kTop, kTop, kBottom, kBottom);
    drawGlow(draw, {width * 0.5f, height * 1.05f}, height * 0.9f, IM_COL32(255, 120, 40, 70));
    drawGlow(draw, {width * 0.5f, height * 1.05f}, height * 0.45f, IM_COL32(255, 190, 110, 60));
}

void setupPart(Context& context, LessonSession& session) {
    LessonSections& sections = session.sections();
    sections.restoreGiven(); // the person may just have switched "for score" on
    if (session.lesson().model == LessonModel::Weld)
        if (const std::string text = simulatedSizesText(session.lesson().workpiece); !text.empty())
            quietText(context, text);
    explainAll(context, sections.start, false);
    if (groupHeading(context, "start", "Machine")) explainAll(context, sections.simulation, false);
    chartPart(context, sections.chart);
    if (!groupHeading(context, "start", "Expert", false)) return;
    explainAll(context, sections.start, true);
    explainAll(context, sections.simulation, true);
}

MenuRequest startMenu(Context& context, LessonSession& session, Home& home, const std::string& driver) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    drawBackdrop(screen.x, screen.y);
    const float width = std::min(context.points(600), screen.x - context.points(24));
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - context.points(16)});
    const bool low = lowerThan(context, 420);
    const ImVec2 padding{context.points(narrowerThan(context, 480) ? 16.0f : 36.0f),
                         context.points(low ? 10.0f : 26.0f)};
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::Begin("start menu", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    taskAndValues(context, session, home, screen.y - context.points(16) - 2 * padding.y);
    const float foot = ImGui::GetCursorPosY();
    if (!low) ImGui::Dummy({0, context.points(8)});
    const MenuRequest request = startButtons(context, session.lesson().torch.duration() > 0);
    if (!low) {
        ImGui::Dummy({0, context.points(2)});
        quietText(context, driver);
    }
    context.startFootHeight = ImGui::GetCursorPosY() - foot + ImGui::GetStyle().ItemSpacing.y;
    ImGui::End();
    return request;
}

} // namespace meltpool::ui
