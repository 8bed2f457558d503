#include "app/ui/widgets.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cfloat>
#include <cmath>
#include <cstring>

namespace meltpool::ui {

namespace {

/// Scrolls the part that holds the item that keys have just chosen, if a piece of the item is out of sight.
void scrollToFocus(Context& context, std::string_view name) {
    if (!ImGui::GetIO().NavVisible || !ImGui::IsItemFocused() || context.lastFocus == name) return;
    context.lastFocus = name;
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    if (ImGui::GetItemRectMin().y < top || ImGui::GetItemRectMax().y > bottom) ImGui::SetScrollHereY(0.5f);
}

} // namespace

void markItem(Context& context, std::string_view name) {
    scrollToFocus(context, name);
    if (!ImGui::IsItemVisible()) return;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    auto known = context.places.find(name);
    if (known == context.places.end()) known = context.places.emplace(name, Place{}).first;
    known->second = {low.x, low.y, high.x - low.x, high.y - low.y, context.frame};
    if (!ImGui::IsItemFocused() || !ImGui::GetIO().NavVisible) return;
    context.focus = name;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float out = context.points(2);
    const ImVec2 from = draw.GetClipRectMin(), to = draw.GetClipRectMax();
    outlineRounded(draw, {std::max(low.x - out, from.x), std::max(low.y - out, from.y)},
                   {std::min(high.x + out, to.x), std::min(high.y + out, to.y)}, colour::kAccent, context.points(6));
}

void noteWindow(Context& context, const char* name) {
    context.windows.note(name, ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows));
}

void beginPart(const char* name, ImVec2 size) {
#if IMGUI_VERSION_NUM < 19090
    ImGui::BeginChild(name, size, false, ImGuiWindowFlags_NavFlattened);
#else
    ImGui::BeginChild(name, size, ImGuiChildFlags_NavFlattened);
#endif
}

namespace {

/// Returns the radius, or 0 if the rectangle is too small for it or has a side that is not a number.
float drawableRadius(ImVec2 low, ImVec2 high, float radius) {
    // Dear ImGui limits the radius to side/2 - 1, and to (side - 1)/2 - 1 for an edge.
    const bool room = std::abs(high.x - low.x) >= 3.5f && std::abs(high.y - low.y) >= 3.5f;
    return room && radius >= 0.5f ? radius : 0.0f;
}

} // namespace

void fillRounded(ImDrawList& draw, ImVec2 low, ImVec2 high, ImU32 tint, float radius, ImDrawFlags corners) {
    draw.AddRectFilled(low, high, tint, drawableRadius(low, high, radius), corners);
}

void outlineRounded(ImDrawList& draw, ImVec2 low, ImVec2 high, ImU32 tint, float radius) {
    draw.AddRect(low, high, tint, drawableRadius(low, high, radius));
}

namespace {

constexpr float kTooltipWidth = 320; ///< points, the most
constexpr double kTooltipRest = 0.5; ///< s that the pointer rests on a control before its tooltip covers others

/// True if the pointer has been over the last item for a while.
bool pointerRests(Context& context) {
    auto& pointed = context.pointed;
    const ImVec2 corner = ImGui::GetItemRectMin();
    const bool same =
        pointed.frame == context.frame || // the first item of a frame counts
        (pointed.frame + 1 == context.frame && pointed.corner.x == corner.x && pointed.corner.y == corner.y);
    if (!same) pointed.since = ImGui::GetTime();
    if (pointed.frame != context.frame) pointed.corner = corner;
    pointed.frame = context.frame;
    return ImGui::GetTime() - pointed.since >= kTooltipRest;
}

void putTooltipAtEdge() {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const bool low = ImGui::GetItemRectMax().y > 0.6f * screen.y;
    ImGui::SetNextWindowPos({screen.x / 2, low ? 0 : screen.y}, ImGuiCond_Always, {0.5f, low ? 0.0f : 1.0f});
}

/// Puts the tooltip of the control that keys have chosen beside the panel, so that it covers no other control; at the
/// edge if there is no room.
void putTooltipBeside(Context& context) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = context.points(44); // the panel's own padding around a scrolling part
    const float need = context.points(kTooltipWidth) + 2 * ImGui::GetStyle().WindowPadding.x + margin;
    const float left = ImGui::GetWindowPos().x, right = left + ImGui::GetWindowWidth();
    if (ImGui::GetWindowHeight() < context.points(60)) return; // a bar covers nothing below it
    const bool atRight = right + need <= screen.x;
    const float low = ImGui::GetItemRectMin().y, high = ImGui::GetItemRectMax().y;
    if (!atRight && left < need) { // a page as wide as the window
        const float gap = context.points(8), row = context.points(60);
        if (low > 0.6f * screen.y) return putTooltipAtEdge();
        const bool first = high < 0.12f * screen.y && ImGui::GetItemRectMin().x > need; // in the page's head
        const ImVec2 place =
            first ? ImVec2{ImGui::GetItemRectMin().x - gap, low} : ImVec2{screen.x / 2, screen.y - row};
        return ImGui::SetNextWindowPos(place, ImGuiCond_Always, first ? ImVec2{1, 0} : ImVec2{0.5f, 1});
    }
    const bool upper = (low + high) / 2 < screen.y / 2;
    ImGui::SetNextWindowPos({atRight ? right + margin : left - margin, upper ? low : high}, ImGuiCond_Always,
                            {atRight ? 0.0f : 1.0f, upper ? 0.0f : 1.0f});
}

/// Returns the end of the letter in UTF-8 that begins at `at`.
const char* letterEnd(const char* at, const char* end) {
    do {
        ++at;
    } while (at < end && (static_cast<unsigned char>(*at) & 0xC0U) == 0x80U);
    return at;
}

/// Returns the end of the line that begins at `at`: between two words if one fits.
const char* lineEnd(const char* at, const char* end, float room) {
    const float scale = ImGui::GetFontSize() / loadedSize(*ImGui::GetFont());
    const char* const wrapped = ImGui::GetFont()->CalcWordWrapPositionA(scale, at, end, room);
    if (wrapped >= end) return end;
    if (wrapped == at) return letterEnd(at, end); // no room for a letter
    const char* word = wrapped;
    while (word > at && *word != ' ')
        --word;
    return word > at ? word : wrapped;
}

} // namespace

void tooltip(Context& context, std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered()) return;
    const bool byKeys = ImGui::GetIO().NavVisible && ImGui::IsItemFocused() &&
                        !ImGui::IsMouseHoveringRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    if (!byKeys && !pointerRests(context)) return;
    if (context.tooltipsAtEdge)
        putTooltipAtEdge();
    else if (byKeys)
        putTooltipBeside(context);
    ImGui::BeginTooltip();
    wrappedText(text, std::min(context.points(kTooltipWidth), ImGui::GetIO().DisplaySize.x - context.points(40)));
    ImGui::EndTooltip();
}

void wrappedText(std::string_view text, float room) {
    if (room <= 0) room = ImGui::GetContentRegionAvail().x;
    const char *at = text.data(), *const end = at + text.size();
    const ImVec2 between = ImGui::GetStyle().ItemSpacing;
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {between.x, 0});
    do {
        const char* const line = std::find(at, end, '\n');
        const char* stop = lineEnd(at, line, room);
        ImGui::TextUnformatted(at, stop);
        at = stop < line ? stop : std::min(line + 1, end);
        while (at < line && *at == ' ')
            ++at;
    } while (at < end);
    ImGui::PopStyleVar();
    ImGui::EndGroup();
}

void quietText(Context& context, std::string_view text) {
    ImGui::PushFont(context.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, colour::kQuiet);
    wrappedText(text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

std::vector<std::string> wholeWords(ImFont& font, float size, std::string_view text, float width, size_t lines) {
    std::vector<std::string> broken;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end && broken.size() < lines) {
        const char* stop = font.CalcWordWrapPositionA(size / loadedSize(font), at, end, width);
        if (stop == at) stop = end; // no room for a single letter
        broken.emplace_back(at, stop);
        at = stop;
        while (at < end && *at == ' ')
            ++at;
    }
    if (at == end || broken.empty()) return broken;
    std::string& last = broken.back();
    const auto tooWide = [&] { return font.CalcTextSizeA(size, FLT_MAX, 0, (last + " ..").c_str()).x > width; };
    const auto openBracket = [&] { // an opened bracket would seem to hold what is cut off
        return last.rfind('(') != std::string::npos && last.find(')', last.rfind('(')) == std::string::npos;
    };
    while ((tooWide() || openBracket()) && last.find(' ') != std::string::npos)
        last.resize(last.rfind(' '));
    last += " ..";
    return broken;
}

void quietLine(Context& context, std::string_view text) {
    ImGui::PushFont(context.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, colour::kQuiet);
    const float room = ImGui::GetContentRegionAvail().x;
    const float wide = ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
    const bool cut = wide > room;
    if (cut) {
        const auto line = wholeWords(*ImGui::GetFont(), ImGui::GetFontSize(), text, room, 1);
        ImGui::TextUnformatted(line.empty() ? "" : line.front().c_str());
    } else {
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (cut) tooltip(context, text);
}

void strongText(Context& context, std::string_view text) {
    ImGui::PushFont(context.fonts.strong);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopFont();
}

ShortText niceNumber(double value) {
    const double size = std::abs(value);
    int decimals = 0;
    if (size > 0 && size < 1000) decimals = std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
    const PhraseNumber text(value, decimals);
    std::string_view number = text;
    if (decimals > 0) {
        number = number.substr(0, number.find_last_not_of('0') + 1);
        // Removes a trailing decimal mark.
        if (std::isdigit(static_cast<unsigned char>(number.back())) == 0) number.remove_suffix(1);
    }
    return number;
}

std::string sentence(std::string_view text) {
    std::string whole = capitalised(text);
    if (whole.empty()) return whole;
    if (whole.back() != '.') whole += '.';
    return whole;
}

ShortText readableName(std::string_view key) {
    ShortText name(key);
    std::replace(name.data(), name.data() + name.size(), '_', ' ');
    if (!name.empty()) name.data()[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name.data()[0])));
    return name;
}

bool narrowerThan(const Context& context, float width) {
    return ImGui::GetIO().DisplaySize.x < context.points(width);
}

bool lowerThan(const Context& context, float height) {
    return ImGui::GetIO().DisplaySize.y < context.points(height);
}

namespace {

constexpr float kTextMargin = 6; ///< smallest margin between a button's text and each side, points

/// Width of a button without a limit, pixels.
float wishedWidth(const Context& context, const char* text, ButtonKind kind, float width) {
    if (kind == ButtonKind::main) ImGui::PushFont(context.fonts.strong);
    const float words = ImGui::CalcTextSize(text).x;
    if (kind == ButtonKind::main) ImGui::PopFont();
    const float margin = width > 0 ? context.points(kTextMargin) : ImGui::GetStyle().FramePadding.x;
    return std::max(context.points(width), words + 2 * margin);
}

/// ImGui::Button whose text stays in the middle where the frame's padding leaves it too little room: ImGui would begin
/// the text at the padding and cut its end off.
bool centredButton(const char* label, float wide) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const float spare = std::max((wide - ImGui::CalcTextSize(label, nullptr, true).x) / 2, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(std::min(padding.x, spare), padding.y));
    const bool clicked = ImGui::Button(label, {wide, 0});
    ImGui::PopStyleVar();
    return clicked;
}

/// Breaks the text into lines of at most `room` pixels.
ShortText brokenIntoLines(const char* text, float room) {
    ShortText lines;
    const char* const end = text + std::strlen(text);
    const float scale = ImGui::GetFontSize() / loadedSize(*ImGui::GetFont());
    while (text < end) {
        const char* stop = ImGui::GetFont()->CalcWordWrapPositionA(scale, text, end, room);
        if (stop == text) stop = end; // no room for a single letter
        lines += std::string_view(text, static_cast<size_t>(stop - text));
        text = stop;
        while (text < end && *text == ' ')
            ++text;
        if (text < end) lines += "\n";
    }
    return lines;
}

} // namespace

bool button(Context& context, std::string_view name, const char* text, ButtonKind kind, float width, const char* note) {
    int colours = 0;
    const float room = ImGui::GetContentRegionAvail().x;
    const float wide = std::min(wishedWidth(context, text, kind, width), std::max(room, context.points(24)));
    const auto push = [&colours](ImGuiCol what, ImU32 value) {
        ImGui::PushStyleColor(what, value);
        ++colours;
    };
    if (kind == ButtonKind::main) {
        push(ImGuiCol_Button, colour::kAccent);
        push(ImGuiCol_ButtonHovered, IM_COL32(255, 160, 92, 255));
        push(ImGuiCol_ButtonActive, colour::kAccentDeep);
        push(ImGuiCol_Text, colour::kOnAccent);
        ImGui::PushFont(context.fonts.strong);
    } else if (kind == ButtonKind::lit) {
        push(ImGuiCol_Button, IM_COL32(255, 138, 61, 46));
        push(ImGuiCol_ButtonHovered, IM_COL32(255, 138, 61, 70));
        push(ImGuiCol_ButtonActive, IM_COL32(255, 138, 61, 90));
        push(ImGuiCol_Text, IM_COL32(255, 178, 122, 255));
    }
    const float words = wide - 2 * std::min(context.points(kTextMargin), ImGui::GetStyle().FramePadding.x);
    const bool fits = ImGui::CalcTextSize(text).x <= words + 1;
    const ShortText label = fits ? ShortText{text, "##", name} : ShortText{brokenIntoLines(text, words), "##", name};
    const bool clicked = centredButton(label.c_str(), wide);
    if (kind == ButtonKind::main) ImGui::PopFont();
    ImGui::PopStyleColor(colours);
    markItem(context, name);
    if (note != nullptr) tooltip(context, note);
    return clicked;
}

ButtonRow::ButtonRow(Context& context, float gap)
    : context_(context),
      gap_(context.points(gap)),
      right_(ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x) {}

void ButtonRow::place(float width) {
    const bool fits = ImGui::GetItemRectMax().x + gap_ + context_.points(width) <= right_ + 0.5f;
    if (!first_ && fits) ImGui::SameLine(0, gap_);
    first_ = false;
}

bool ButtonRow::add(std::string_view name, const char* text, ButtonKind kind, float width, const char* note) {
    place(wishedWidth(context_, text, kind, width) / context_.scale);
    return button(context_, name, text, kind, width, note);
}

bool toggle(Context& context, std::string_view name, std::string_view label, bool& value, const char* note,
            bool* hoveredNow) {
    const float wide = context.points(36);
    const float width = ImGui::GetContentRegionAvail().x;
    const float room = std::max(width - wide - context.points(6), 1.0f);
    const float words = ImGui::CalcTextSize(label.data(), label.data() + label.size(), false, room).y;
    const float height = words + context.points(8);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(ShortText(name).c_str(), {width, height});
    if (clicked) value = !value;
    const bool hovered = ImGui::IsItemHovered();
    if (hoveredNow != nullptr) *hoveredNow = hovered;
    markItem(context, name);
    if (note != nullptr) tooltip(context, note);

    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float thick = context.points(20);
    const ImVec2 track{corner.x + width - wide, corner.y + (height - thick) / 2};
    const ImU32 fill = value ? colour::kAccent : (hovered ? colour::kFieldHot : colour::kTrack);
    fillRounded(*draw, track, {track.x + wide, track.y + thick}, fill, thick / 2);
    const float knob = thick / 2 - context.points(3);
    const float x = value ? track.x + wide - thick / 2 : track.x + thick / 2;
    draw->AddCircleFilled({x, track.y + thick / 2}, knob, value ? IM_COL32_WHITE : IM_COL32(190, 197, 208, 255), 24);
    draw->AddText(nullptr, 0, {corner.x, corner.y + context.points(4)}, colour::kText, label.data(),
                  label.data() + label.size(), room);
    return clicked;
}

bool choiceRow(Context& context, std::string_view name, std::span<const std::string_view> choices, int& value,
               std::string_view words, std::span<const std::string_view> names) {
    const float gap = context.points(5);
    const float right = ImGui::GetContentRegionAvail().x;
    float used = 0;
    bool changed = false;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {context.points(8), context.points(4)});
    for (size_t i = 0; i < choices.size(); ++i) {
        const ShortText readable = readableName(choices[i]);
        const bool named = i < names.size() && !names[i].empty();
        const ShortText text = named ? names[i] : phraseOr(ShortText{words, ".", choices[i]}, readable);
        const float width = ImGui::CalcTextSize(text.c_str()).x + context.points(16);
        if (i > 0 && used + gap + width <= right) {
            ImGui::SameLine(0, gap);
            used += gap;
        } else {
            used = 0;
        }
        used += width;
        const bool chosen = value == static_cast<int>(i);
        const ShortText place{name, ".", choices[i]};
        if (button(context, place, text.c_str(), chosen ? ButtonKind::lit : ButtonKind::plain) && !chosen) {
            value = static_cast<int>(i);
            changed = true;
        }
    }
    ImGui::PopStyleVar();
    return changed;
}

namespace {

/// Makes "group.expert_surface" of "Expert: surface".
ShortText groupKey(std::string_view title) {
    ShortText key("group.");
    bool gap = false;
    for (const char c : title) {
        const bool capital = c >= 'A' && c <= 'Z', letter = capital || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (!letter) {
            gap = true;
            continue;
        }
        if (gap) key += "_";
        gap = false;
        const char small = capital ? static_cast<char>(c - 'A' + 'a') : c;
        key += std::string_view(&small, 1);
    }
    return key;
}

} // namespace

bool groupHeading(Context& context, std::string_view prefix, const char* title, bool openAtFirst) {
    return namedHeading(context, prefix, title, phraseOr(groupKey(title), title), openAtFirst);
}

bool namedHeading(Context& context, std::string_view prefix, const char* name, std::string_view title,
                  bool openAtFirst) {
    ImGui::Dummy({0, context.points(4)});
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(name);
    bool open = storage->GetBool(id, openAtFirst);
    ImGui::PushFont(context.fonts.strong);
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetTextLineHeight() + context.points(6);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(name, {width, height})) {
        open = !open;
        storage->SetBool(id, open);
    }
    markItem(context, ShortText{prefix, ".group.", name});
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImU32 tint = ImGui::IsItemHovered() ? IM_COL32(255, 205, 168, 255) : IM_COL32(255, 178, 122, 255);
    draw->AddText({corner.x, corner.y + context.points(3)}, tint, title.data(), title.data() + title.size());
    ImGui::PopFont();
    // A chevron at the right points down if open, to the side if folded.
    const ImVec2 centre{corner.x + width - context.points(8), corner.y + height / 2};
    const float r = context.points(4);
    const ImVec2 middle = open ? ImVec2{centre.x, centre.y + r / 2} : ImVec2{centre.x + r / 2, centre.y};
    const ImVec2 first = open ? ImVec2{centre.x - r, centre.y - r / 2} : ImVec2{centre.x - r / 2, centre.y - r};
    const ImVec2 last = open ? ImVec2{centre.x + r, centre.y - r / 2} : ImVec2{centre.x - r / 2, centre.y + r};
    const std::array<ImVec2, 3> line{first, middle, last};
    draw->AddPolyline(line.data(), 3, tint, 0, context.points(1.8f));
    const float low = corner.y + height + context.points(1);
    draw->AddLine({corner.x, low}, {corner.x + width, low}, colour::kPanelEdge);
    return open;
}

} // namespace meltpool::ui
