// Draws the views into the weld: cut open at any place, and bent, for the window and the headset's panel.
#include "app/session/bend_drawing.hpp"
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cfloat>
#include <span>
#include <vector>

namespace meltpool::ui {

namespace {

constexpr ImU32 kSteel = IM_COL32(112, 120, 132, 255);
constexpr ImU32 kWeld = IM_COL32(176, 158, 128, 255);
constexpr ImU32 kOpening = IM_COL32(20, 12, 10, 255);
constexpr ImU32 kEdge = IM_COL32(232, 74, 50, 255);
constexpr float kLargest = 8; ///< points a millimetre of a drawing

/// Draws the place of the cut as a slider over the whole seam.
void placeSlider(Context& context, CutView& cut) {
    auto place = static_cast<float>(cut.place() * 1e3);
    const Parameter parameter{"place",
                              phrase("weld_view.cut.place"),
                              "mm",
                              &place,
                              cut.reach().low * 1e3,
                              cut.reach().high * 1e3,
                              phrase("weld_view.cut.place_tooltip")};
    static const DefaultTexts kNone;
    if (parameterControl(context, "cut", parameter, kNone)) cut.moveTo(static_cast<double>(place) * 1e-3);
}

void drawShape(ImDrawList& draw, const BendShape& shape, ImVec2 origin, float scale) {
    std::vector<ImVec2> points;
    for (const glm::vec2 point : shape.points)
        points.push_back({origin.x + point.x * scale, origin.y + point.y * scale});
    const int count = static_cast<int>(points.size());
    switch (shape.part) {
    case BendPart::steel:
        draw.AddConvexPolyFilled(points.data(), count, kSteel);
        break;
    case BendPart::weld:
        draw.AddConvexPolyFilled(points.data(), count, kWeld);
        break;
    case BendPart::opening:
        draw.AddConvexPolyFilled(points.data(), count, kOpening);
        draw.AddPolyline(points.data(), count, kEdge, ImDrawFlags_Closed, 1.5f);
        break;
    case BendPart::unresolved:
        draw.AddPolyline(points.data(), count, colour::kWarning, ImDrawFlags_Closed, 1.5f);
        break;
    }
}

void drawSheet(Context& context, const BendDrawing& drawing) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float scale = std::min(width / drawing.size.x, context.points(kLargest));
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImDrawListFlags before = draw->Flags;
    draw->Flags &= ~ImDrawListFlags_AntiAliasedFill; // antialiasing leaves seams between the pieces of the bend
    for (const BendShape& shape : drawing.shapes)
        drawShape(*draw, shape, origin, scale);
    draw->Flags = before;
    for (const BendLabel& label : drawing.labels) {
        const float half = 0.5f * ImGui::CalcTextSize(label.text.c_str()).x;
        const float x = std::clamp(origin.x + label.place.x * scale - half, origin.x,
                                   std::max(origin.x, origin.x + width - 2 * half));
        draw->AddText({x, origin.y + label.place.y * scale}, colour::kQuiet, label.text.c_str());
    }
    ImGui::Dummy({width, drawing.size.y * scale});
}

} // namespace

void cueNames(Context& context, std::span<const NamedCue> cues) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImDrawList* draw = ImGui::GetBackgroundDrawList();
    const float usual = loadedSize(*context.fonts.small) * ImGui::GetIO().FontGlobalScale;
    for (const NamedCue& cue : cues) {
        const ShortText text(cueWords(cue.kind).shown(cue.correction));
        const char* const name = text.c_str();
        const float least = 0.55f * usual, room = cue.width * screen.x;
        const float wide = context.fonts.small->CalcTextSizeA(usual, FLT_MAX, 0, name).x;
        const float size = std::clamp(usual * room / std::max(wide, 1.0f), least, usual);
        const ImVec2 words = context.fonts.small->CalcTextSizeA(size, FLT_MAX, 0, name);
        const ImVec2 at{cue.place.x * screen.x - words.x / 2, cue.place.y * screen.y - (cue.above ? words.y : 0)};
        const auto shade = static_cast<int>(190 * std::min(1.0f, cue.opacity / 0.6f));
        fillRounded(*draw, {at.x - 2, at.y}, {at.x + words.x + 2, at.y + words.y}, IM_COL32(22, 25, 31, shade), 0);
        draw->AddText(context.fonts.small, size, at, colour::kText, name);
    }
}

MenuRequest cutPart(Context& context, LessonSession& session) {
    CutView& cut = session.picture().cut();
    if (!cut.shown() && !session.cuts()) return MenuRequest::none;
    MenuRequest request = MenuRequest::none;
    ShortText note;
    appendPhrase(note, "weld_view.cut.tooltip", {{"key", context.key(Key::x)}});
    if (button(context, "cut.open", phrase(cut.shown() ? "weld_view.cut.close" : "weld_view.cut.open").c_str(),
               cut.shown() ? ButtonKind::lit : ButtonKind::plain, 150, note.c_str()))
        request = MenuRequest::cut;
    if (!cut.shown()) return request;
    placeSlider(context, cut);
    quietText(context, cutNote(cut));
    return request;
}

void bendPart(Context& context, const BendTest& test) {
    const bool broken = test.former <= 0;
    if (!groupHeading(context, "result", broken ? "Fillet break" : "Bend test")) return;
    quietText(context, phrase(broken ? "weld_view.break.rule" : "weld_view.bend.rule"));
    for (const BentStrap& strap : test.straps) {
        const bool good = strap.state == VerdictState::pass, bad = strap.state == VerdictState::fail;
        ImGui::PushStyleColor(ImGuiCol_Text, good  ? IM_COL32(134, 214, 140, 255)
                                             : bad ? IM_COL32(255, 138, 120, 255)
                                                   : colour::kWarning);
        wrappedText(bendSentence(strap));
        ImGui::PopStyleColor();
        drawSheet(context, drawBend(strap, test));
        markItem(context, "result.bend");
    }
}

} // namespace meltpool::ui
