// Draws the bars at the top and bottom of the running trainer, the messages above them and the colour scale.
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"
#include "core/render/look/temperature_scale.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meltpool::ui {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar |
                                    ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus;
constexpr const char* kMessages = "messages"; ///< name of their window

void beginBar(Context& context, const char* name, float y) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, y});
    ImGui::SetNextWindowSize({screen.x, barHeight(context)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.points(14), context.points(7)});
    ImGui::Begin(name, nullptr, kFixed);
    ImGui::PopStyleVar(3);
}

/// Name of the mode: the person at work, and the state of the metal.
struct ModeName {
    std::string_view key; ///< key of its phrase
    ImU32 tint;
};

ModeName modeOf(const Controls& controls, const LessonSession& session) {
    if (session.picture().cut().shown()) return {"bar.mode.cut_open", colour::kCold};
    // A demonstration continues while the person looks around.
    const Activities& activities = session.activities();
    if (activities.at(activities.demonstration)) return {"bar.mode.demonstration", colour::kCold};
    if (activities.at(activities.replay)) return {"bar.mode.replay", colour::kCold};
    if (controls.mode() == Mode::interact) return {"bar.mode.working", colour::kAccent};
    return {"bar.mode.looking", colour::kCold};
}

/// Draws a rounded label in the middle of the bar.
void modeSign(Context& context, const ModeName& mode, float left, float right) {
    const char* const text = phrase(mode.key).c_str();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    ImGui::PushFont(context.fonts.strong);
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float y = (barHeight(context) - size.y) / 2;
    const float dot = context.points(4.5f);
    // The sign is in the window's middle, or moved by the buttons; a very small window shows only the dot.
    const float x = std::clamp((screen.x - size.x) / 2, left + 4 * dot, std::max(left + 4 * dot, right - size.x - dot));
    const bool fits = x + size.x < right;
    draw->AddCircleFilled({x - dot * 3, y + size.y / 2}, dot, mode.tint, 16);
    if (fits) draw->AddText({x, y}, mode.tint, text);
    ImGui::PopFont();
}

/// Describes the torch's pose: "Tip to work 15 mm, side lean 0°, push 10°".
ShortText torchText(const LessonFigures& f) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    const bool tip = f.distance == DistanceKind::ctwd;
    const double travel = std::round(f.torch->travel * kDegrees);
    ShortText text;
    appendPhrase(text,
                 tip ? (travel < 0 ? "bar.figures.ctwd_drag" : "bar.figures.ctwd")
                     : (travel < 0 ? "bar.figures.arc_length_drag" : "bar.figures.arc_length"),
                 {{"distance", PhraseNumber(f.torch->distance * 1e3, tip ? 0 : 1)},
                  {"work", PhraseNumber(f.torch->work * kDegrees, 0, true)},
                  {"travel", PhraseNumber(std::abs(travel))}});
    return text;
}

/// Between the figures of the bar; the words of the metal have it too.
constexpr std::string_view kBetween = "   \xC2\xB7   ";

ShortText metalText(const LessonFigures& f) {
    const double share = f.particles > 0 ? 100.0 * static_cast<double>(f.molten) / static_cast<double>(f.particles) : 0;
    ShortText text;
    appendPhrase(text, "bar.figures.metal",
                 {{"seconds", PhraseNumber(f.time, 1)},
                  {"particles", PhraseNumber(static_cast<double>(f.particles))},
                  {"molten", PhraseNumber(share, 1)},
                  {"hottest", hottestText(f)}});
    return text;
}

/// Describes the metal, or the torch if it is led along a seam.
ShortText figuresText(const LessonFigures& f) {
    ShortText all = f.torch && !f.stopped ? torchText(f) : metalText(f);
    const std::string_view pace = f.stopped ? std::string_view(phrase("bar.figures.stopped")) : f.slow;
    for (const std::string_view more : {pace, f.picture, f.detail}) {
        if (more.empty()) continue;
        all += kBetween;
        all += more;
    }
    return all;
}

/// Leaves out the last figures until the text is no wider than `room`; the first one stays. Between the torch's
/// own figures are only blanks.
ShortText fitting(const ShortText& figures, float room) {
    std::string_view text(figures.c_str());
    while (ImGui::CalcTextSize(text.data(), text.data() + text.size()).x > room) {
        size_t end = text.rfind(kBetween);
        if (end == std::string_view::npos) end = text.rfind("   ");
        if (end == std::string_view::npos) break;
        text = text.substr(0, end);
    }
    return {text};
}

/// Returns the room that the hint takes; 0: the row has none.
float hintWidth(const Context& context, const KeyRow& row) {
    const ShortText key = row.hint.empty() ? ShortText() : keyRowName(context, row);
    if (key.empty()) return 0;
    return ImGui::CalcTextSize(key.c_str()).x + ImGui::CalcTextSize(phrase(row.hint).c_str()).x + context.points(40);
}

/// Draws a key's name in a small frame, and its effect.
void keyHint(Context& context, const char* key, const char* what) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImVec2 size = ImGui::CalcTextSize(key);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float pad = context.points(5);
    fillRounded(*draw, {at.x, at.y - context.points(1)}, {at.x + size.x + 2 * pad, at.y + size.y + context.points(1)},
                colour::kTrack, context.points(4));
    draw->AddText({at.x + pad, at.y}, colour::kText, key);
    ImGui::Dummy({size.x + 2 * pad, size.y});
    ImGui::SameLine(0, context.points(6));
    ImGui::PushStyleColor(ImGuiCol_Text, colour::kQuiet);
    ImGui::TextUnformatted(what);
    ImGui::PopStyleColor();
    ImGui::SameLine(0, context.points(16));
}

constexpr float kWholeBar = 788;    ///< points at which every button of the bar has room
constexpr float kNamedBar = 848;    ///< points at which the program's name has room too
constexpr float kCommandWidth = 72; ///< points
constexpr float kAttemptWidth = 96; ///< points, of the buttons for a new attempt and for the lesson's page

/// Draws the buttons that open and close the panels: in a row, or each in a row of its own if it has a width (points).
/// Returns true if one was pressed.
bool barTabs(Context& context, PanelState& panels, const LessonSession& session, float width) {
    bool pressed = false;
    const auto tab = [&](const char* name, const char* text, bool& open, const char* note) {
        if (button(context, name, text, open ? ButtonKind::lit : ButtonKind::plain, width, note)) {
            open = !open;
            pressed = true;
        }
        if (width <= 0) ImGui::SameLine(0, context.points(6));
    };
    tab("bar.view", phrase("bar.button.view").c_str(), panels.view, phrase("bar.tooltip.view").c_str());
    tab("bar.simulation", phrase("bar.button.machine").c_str(), panels.simulation,
        phrase("bar.tooltip.machine").c_str());
    tab("bar.timings", phrase("bar.button.timings").c_str(), panels.timings, phrase("bar.tooltip.timings").c_str());
    if (session.judges()) {
        ShortText note;
        appendPhrase(note, "bar.tooltip.result", {{"key", context.key(Key::j)}});
        tab("bar.result", phrase("bar.button.result").c_str(), panels.result, note.c_str());
    }
    return pressed;
}

bool resetButton(Context& context, float width) {
    return button(context, "bar.reset", phrase("bar.button.reset").c_str(), ButtonKind::plain, width,
                  phrase("bar.tooltip.reset").c_str());
}

/// Draws the buttons that leave the running lesson.
MenuRequest wayButtons(Context& context, float lessonWidth, float width, bool beside = true) {
    MenuRequest request = MenuRequest::none;
    if (button(context, "bar.restart", phrase("bar.button.restart").c_str(), ButtonKind::plain, lessonWidth,
               phrase("bar.tooltip.restart").c_str()))
        request = MenuRequest::restart;
    if (beside) ImGui::SameLine(0, context.points(6));
    ShortText note;
    appendPhrase(note, "bar.tooltip.home", {{"key", context.key(Key::h)}});
    if (button(context, "bar.home", phrase("bar.button.home").c_str(), ButtonKind::plain, width, note.c_str()))
        request = MenuRequest::home;
    return request;
}

/// Draws the buttons for which a narrow bar has no room, one below the other under a button of their own.
MenuRequest barMenu(Context& context, PanelState& panels, const LessonSession& session) {
    constexpr float kWidth = 150;
    MenuRequest request = MenuRequest::none;
    if (button(context, "bar.menu", phrase("bar.button.menu").c_str(), ButtonKind::plain, kCommandWidth))
        ImGui::OpenPopup("bar menu");
    const float left = ImGui::GetItemRectMin().x, top = barHeight(context);
    const float width =
        context.points(kWidth) + 2 * ImGui::GetStyle().WindowPadding.x + ImGui::GetStyle().ScrollbarSize;
    ImGui::SetNextWindowPos({left, top});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, ImGui::GetIO().DisplaySize.y - top - context.points(8)});
    if (!ImGui::BeginPopup("bar menu")) return request;
    const bool pressed = barTabs(context, panels, session, kWidth);
    request = wayButtons(context, kWidth, kWidth, false);
    if (pressed || request != MenuRequest::none) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return request;
}

} // namespace

ShortText hottestText(const LessonFigures& figures) {
    if (!figures.kelvin) return niceNumber(std::round(figures.hottest * 100) / 100);
    return {niceNumber(std::round(figures.hottest - 273.15)), " \xC2\xB0", "C"};
}

float barHeight(const Context& context) {
    return context.points(48);
}

MenuRequest topBar(Context& context, PanelState& panels, const Controls& controls, const LessonSession& session) {
    MenuRequest request = MenuRequest::none;
    beginBar(context, kTopBar, 0);
    noteWindow(context, kTopBar);
    drawSign(*ImGui::GetWindowDrawList(), {context.points(28), barHeight(context) / 2}, context.points(28));
    ImGui::SetCursorPosX(context.points(50));
    ImGui::AlignTextToFramePadding();
    const bool narrow = narrowerThan(context, kWholeBar);
    if (!narrowerThan(context, kNamedBar)) { // a narrow bar has room for its buttons only
        strongText(context, "Meltpool");
        ImGui::SameLine(0, context.points(18));
    }
    float end = ImGui::GetCursorScreenPos().x + context.points(kCommandWidth);
    if (narrow) {
        request = barMenu(context, panels, session);
    } else {
        barTabs(context, panels, session, 0);
        end = ImGui::GetItemRectMax().x;
    }
    const float widths = narrow ? kAttemptWidth + kCommandWidth : 2 * (kAttemptWidth + kCommandWidth);
    const float gaps = narrow ? 1 : 3;
    const float buttons = ImGui::GetIO().DisplaySize.x - context.points(widths + 14 + 6 * gaps);
    modeSign(context, modeOf(controls, session), end, buttons);
    ImGui::SameLine();
    ImGui::SetCursorPosX(buttons);
    if (resetButton(context, kAttemptWidth)) request = MenuRequest::reset;
    ImGui::SameLine(0, context.points(6));
    if (!narrow) {
        if (const MenuRequest asked = wayButtons(context, kAttemptWidth, kCommandWidth); asked != MenuRequest::none)
            request = asked;
        ImGui::SameLine(0, context.points(6));
    }
    ShortText note;
    appendPhrase(note, "bar.tooltip.help", {{"lesson", session.lesson().title}});
    if (button(context, "bar.help", phrase("bar.button.help").c_str(),
               panels.help ? ButtonKind::lit : ButtonKind::plain, kCommandWidth, note.c_str()))
        panels.help = !panels.help;
    ImGui::End();
    return request;
}

void captionLine(Context& context, std::string_view caption, float left, float right) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float edge = context.points(8);
    if (screen.x - left - right < context.points(200)) left = right = 0; // the panels leave it too little room
    const float room = screen.x - left - right - 4 * edge;
    const ImVec2 size = ImGui::CalcTextSize(caption.data(), caption.data() + caption.size(), false, room);
    const float x = (left + screen.x - right - size.x) / 2;
    const float y = screen.y - barHeight(context) - size.y - context.points(24);
    ImDrawList* draw = ImGui::GetBackgroundDrawList();
    fillRounded(*draw, {x - edge, y - edge / 2}, {x + size.x + edge, y + size.y + edge / 2}, IM_COL32(22, 25, 31, 190),
                context.points(6));
    draw->AddText(nullptr, 0, {x, y}, colour::kText, caption.data(), caption.data() + caption.size(), room);
}

void statusBar(Context& context, const LessonFigures& figures, const KeySituation& now) {
    const float height = barHeight(context);
    beginBar(context, "status bar", ImGui::GetIO().DisplaySize.y - height);
    ImGui::PushFont(context.fonts.small);
    ImGui::SetCursorPosY((height - ImGui::GetTextLineHeight()) / 2);
    const KeyGuide guide(now);
    // In a narrow window the weightiest hint has room before the last figures.
    float first = 0;
    for (const KeyRow& row : guide.rows())
        if (first <= 0) first = hintWidth(context, row);
    const float screen = ImGui::GetIO().DisplaySize.x, edge = context.points(16);
    // A weld that is cut open rests, and so does the torch.
    const ShortText text = now.cut ? ShortText() : fitting(figuresText(figures), screen - 2 * edge - first);
    const float right = std::max(screen - ImGui::CalcTextSize(text.c_str()).x - edge, edge);
    for (const KeyRow& row : guide.rows()) {
        const float need = hintWidth(context, row);
        if (need <= 0) continue;
        if (ImGui::GetCursorPosX() + need > right) break;
        keyHint(context, keyRowName(context, row).c_str(), phrase(row.hint).c_str());
    }
    ImGui::GetWindowDrawList()->AddText({right, ImGui::GetWindowPos().y + (height - ImGui::GetTextLineHeight()) / 2},
                                        colour::kText, text.c_str());
    ImGui::PopFont();
    ImGui::End();
}

void letWheelThroughMessages(bool wheelMoves) {
    if (!wheelMoves) return;
    if (ImGuiWindow* const window = ImGui::FindWindowByName(kMessages))
        window->Flags |= ImGuiWindowFlags_NoMouseInputs; // Begin() of this frame takes it back
}

void messageStack(Context& context, Messages& messages, float left, float right, bool welds) {
    constexpr float kLow = 400; // points: a message would cover the arc
    if (messages.shown().empty() || (welds && lowerThan(context, kLow))) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    // Messages lie over the panels if those leave too little room.
    const bool over = screen.x - left - right < context.points(260);
    if (over) left = right = 0;
    const float width = std::min(context.points(620), screen.x - left - right - context.points(40));
    ImGui::SetNextWindowPos({(left + screen.x - right) / 2, barHeight(context) + context.points(10)}, ImGuiCond_Always,
                            {0.5f, 0});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin(kMessages, nullptr,
                 (kFixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    ImDrawList* draw = over ? ImGui::GetForegroundDrawList() : ImGui::GetWindowDrawList();
    const float pad = context.points(11);
    const Message* dismissed = nullptr;
    for (const Message& message : messages.shown()) {
        const bool warning = message.kind == Message::Kind::warning;
        const float inner = width - 3 * pad;
        const ImVec2 size = ImGui::CalcTextSize(message.text.c_str(), nullptr, false, inner);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::PushID(&message);
        if (ImGui::InvisibleButton("message", {width, size.y + 2 * pad})) dismissed = &message;
        ImGui::PopID();
        const ImVec2 end{at.x + width, at.y + size.y + 2 * pad};
        fillRounded(*draw, at, end, IM_COL32(38, 43, 53, 252), context.points(8));
        outlineRounded(*draw, at, end, IM_COL32(255, 255, 255, 30), context.points(8));
        fillRounded(*draw, at, {at.x + context.points(5), end.y}, warning ? colour::kWarning : colour::kAccent,
                    context.points(8), ImDrawFlags_RoundCornersLeft);
        draw->AddText(nullptr, 0, {at.x + 2 * pad, at.y + pad}, colour::kText, message.text.c_str(), nullptr, inner);
    }
    ImGui::End();
    if (dismissed != nullptr) messages.dismiss(*dismissed);
}

void temperatureScale(Context& context, int colours, const TemperatureMeaning& meaning, float left) {
    if (colours == kMaterialColours) return;
    ImDrawList* draw = ImGui::GetBackgroundDrawList();
    const float width = context.points(14);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float height = std::min(context.points(180), screen.y - 2 * barHeight(context) - context.points(28 + 40));
    const float x = context.points(24) + left;
    if (height < context.points(60) || x + context.points(80) > screen.x) return; // a small window has no room for it
    const float y = screen.y - barHeight(context) - height - context.points(28);
    constexpr int kParts = 32;
    const float part = height / kParts;
    const auto tint = [colours](int step) {
        const glm::vec3 c = temperatureColour(static_cast<ColourMode>(colours), static_cast<float>(step) / kParts);
        return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
    };
    fillRounded(*draw, {x - context.points(10), y - context.points(34)},
                {x + width + context.points(64), y + height + context.points(14)}, IM_COL32(22, 25, 31, 190),
                context.points(8));
    for (int i = 0; i < kParts; ++i) {
        const float top = y + part * static_cast<float>(kParts - 1 - i);
        const ImU32 lower = tint(i);
        const ImU32 upper = tint(i + 1);
        draw->AddRectFilledMultiColor({x, top}, {x + width, top + part}, upper, upper, lower, lower);
    }
    draw->AddText(context.fonts.small, loadedSize(*context.fonts.small) * ImGui::GetIO().FontGlobalScale,
                  {x - context.points(2), y - context.points(29)}, colour::kQuiet, phrase("bar.scale.heading").c_str());
    const auto degrees = [&meaning](float share) {
        const float kelvin = meaning.coldest + share * (meaning.hottest - meaning.coldest);
        return ShortText{niceNumber(std::round(static_cast<double>(kelvin) - 273.15)), " \xC2\xB0", "C"};
    };
    std::array<ShortText, 3> labels;
    if (meaning.kelvin)
        labels = {degrees(1), degrees(0.5f), degrees(0)};
    else
        labels = {ShortText(phrase("bar.scale.liquid")), ShortText(PhraseNumber(0.5, 1)),
                  ShortText(phrase("bar.scale.solid"))};
    for (size_t i = 0; i < 3; ++i)
        draw->AddText(context.fonts.small, loadedSize(*context.fonts.small) * ImGui::GetIO().FontGlobalScale,
                      {x + width + context.points(8), y + height / 2 * static_cast<float>(i) - context.points(9)},
                      colour::kText, labels[i].c_str());
}

} // namespace meltpool::ui
