// The weld looked into: cut open at any place, and bent. For the window and the headset's panel.
#include "app/session/bend_drawing.hpp"
#include "app/ui/panels.hpp"

#include <algorithm>
#include <cstdio>
#include <span>
#include <vector>

namespace meltpool::ui {

namespace {

constexpr ImU32 kSteel = IM_COL32(112, 120, 132, 255);
constexpr ImU32 kWeld = IM_COL32(176, 158, 128, 255);
constexpr ImU32 kOpening = IM_COL32(20, 12, 10, 255);
constexpr ImU32 kEdge = IM_COL32(232, 74, 50, 255);
constexpr float kLargest = 8; ///< points a millimetre of a drawing

/// The place of the cut as a slider over the whole seam.
void placeSlider(Context& context, CutView& cut) {
    auto place = static_cast<float>(cut.place() * 1e3);
    const Parameter parameter{"place",
                              "Place of the cut",
                              "mm",
                              &place,
                              cut.reach().low * 1e3,
                              cut.reach().high * 1e3,
                              "along the seam; arrow keys go 1 mm, and a dragging mouse moves it in the picture"};
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
    draw->Flags &= ~ImDrawListFlags_AntiAliasedFill; // it leaves seams between the pieces of the bend
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

const char* ruleOf(const BendTest& test) {
    if (test.former <= 0)
        return "The fillet is broken open from its root, as AWS D1.1 breaks its test fillets. It must be fused to the "
               "root "
               "all along. The broken face is shown with the root at its lower edge.";
    return "Straps as AWS D1.1 bends them, 180\xC2\xB0 round four times their thickness. No opening may be longer than "
           "3 mm, "
           "and those over 1 mm not more than 10 mm together. Every strap of this weld is bent both ways.";
}

} // namespace

MenuRequest cutPart(Context& context, LessonSession& session) {
    CutView& cut = session.picture().cut();
    if (!cut.shown() && !session.cuts()) return MenuRequest::none;
    MenuRequest request = MenuRequest::none;
    if (button(context, "cut.open", cut.shown() ? "Close the cut" : "Cut the weld open",
               cut.shown() ? ButtonKind::lit : ButtonKind::plain, 150,
               ShortText{"Shows the section with what is measured in it; the metal waits meanwhile (",
                         context.key(Key::x), ")"}
                   .c_str()))
        request = MenuRequest::cut;
    if (!cut.shown()) return request;
    placeSlider(context, cut);
    quietText(context, cutNote(cut));
    return request;
}

void bendPart(Context& context, const BendTest& test) {
    const bool broken = test.former <= 0;
    if (!groupHeading(context, "result", broken ? "Fillet break" : "Bend test")) return;
    quietText(context, ruleOf(test));
    for (const BentStrap& strap : test.straps) {
        const bool good = strap.state == VerdictState::pass, bad = strap.state == VerdictState::fail;
        ImGui::PushStyleColor(ImGuiCol_Text, good  ? IM_COL32(134, 214, 140, 255)
                                             : bad ? IM_COL32(255, 138, 120, 255)
                                                   : colour::kWarning);
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(bendSentence(strap).c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopStyleColor();
        drawSheet(context, drawBend(strap, test));
        markItem(context, "result.bend");
    }
}

} // namespace meltpool::ui
