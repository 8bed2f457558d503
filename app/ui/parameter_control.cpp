// Draws the control of one described parameter: a slider for numbers, a switch, a row of choices, three fields for a
// vector.
#include "app/ui/number_entry.hpp"
#include "app/ui/widgets.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool::ui {

namespace {

/// Maps values to positions along a slider. If the range is much wider than the usual value, the scale is linear up to
/// `even` and logarithmic above, so that values near the usual one can be set finely.
struct Scale {
    double low;
    double high;
    double even = 0; ///< length of the linear part; 0: linear throughout

    /// Of a parameter in its shown unit. `usual`: its usual value as text, in its own unit.
    Scale(const Parameter& p, const ShownUnit& unit, std::string_view usual)
        : low(p.minimum * unit.perMetric), high(p.maximum * unit.perMetric) {
        const auto metric = parseDouble(usual);
        const double value = metric.value_or(0) * unit.perMetric;
        if (metric && value > low && high - low >= 10 * (value - low)) even = (value - low) / 30;
    }
    double toShare(double value) const {
        if (high <= low) return 0;
        const double way = value - low;
        const double share = even > 0 ? std::log1p(way / even) / std::log1p((high - low) / even) : way / (high - low);
        return std::clamp(share, 0.0, 1.0);
    }
    double fromShare(double share) const {
        return low + (even > 0 ? even * std::expm1(share * std::log1p((high - low) / even)) : share * (high - low));
    }
    /// Rounds to three digits of the value, or of the range if the scale is linear.
    double rounded(double value, bool whole) const {
        const double size = even > 0 ? std::max(std::abs(value), even) : high - low;
        const double step = std::pow(10.0, std::floor(std::log10(std::max(size, 1e-12))) - 2);
        const double grain = whole ? std::max(step, 1.0) : step;
        return std::clamp(std::round(value / grain) * grain, low, high);
    }
};

/// Prefix of the keys for a choice's phrases: the table's own if a language has them, else the parameter key's.
ShortText choiceWords(std::string_view table, const Parameter& p) {
    const ShortText own{"parameter.", table, ".", p.key, ".choice"};
    if (!p.choices.empty() && findPhrase(ShortText{own, ".", p.choices.front()}) != nullptr) return own;
    return {"parameter.", p.key, ".choice"};
}

/// Text of a value for people: a choice's name and a switch's state have phrases.
std::string_view shownText(std::string_view table, const Parameter& p, std::string_view text) {
    for (size_t i = 0; i < p.choiceNames.size(); ++i)
        if (p.choices[i] == text && !p.choiceNames[i].empty()) return p.choiceNames[i];
    if (!p.choices.empty()) return phraseOr(ShortText{choiceWords(table, p), ".", text}, text);
    if (std::holds_alternative<bool*>(p.value)) return phrase(text == "true" ? "control.true" : "control.false");
    return text;
}

/// shownText(), with numbers in the unit that is shown.
std::string inItsUnit(std::string_view table, const Parameter& p, std::string_view text) {
    const std::string_view shown = shownText(table, p, text);
    return shownUnit(p.unit).converts() ? std::string(inShownUnit(shown, p.unit)) : std::string(shown);
}

/// Makes the text of expectation() for a person who reads the menus.
std::string allowedText(std::string_view table, const Parameter& p) {
    if (!p.choices.empty()) {
        std::string list;
        for (const std::string_view choice : p.choices) {
            if (!list.empty()) list += phrase("list.separator");
            list += shownText(table, p, choice);
        }
        return phrase("control.allowed.one_of", {{"choices", list}});
    }
    if (std::holds_alternative<bool*>(p.value)) return phrase("control.allowed.switch");
    if (std::holds_alternative<std::string*>(p.value)) return phrase("control.allowed.text");
    const bool whole = std::holds_alternative<int*>(p.value), vector = std::holds_alternative<glm::vec3*>(p.value);
    const ShortText key{"control.allowed.",
                        whole    ? "whole_number"
                        : vector ? "three_numbers"
                                 : "number",
                        p.unit.empty() ? "" : "_with_unit"};
    return phrase(key, {{"low", withDecimalMark(formatNumber(p.minimum))},
                        {"high", withDecimalMark(formatNumber(p.maximum))},
                        {"unit", p.unit}});
}

std::string description(std::string_view table, const Parameter& p, std::string_view original) {
    std::string text = sentence(translatedNote(table, p));
    if (!text.empty()) text += "\n\n";
    text += allowedText(table, p);
    if (!original.empty()) text += " " + phrase("control.at_first", {{"value", inItsUnit(table, p, original)}});
    return text;
}

NumberEntry entry; ///< the one text field of the interface

/// Value that a slider had before the mouse pressed it: a double click opens the text field and changes nothing.
struct {
    std::string name;
    double value = 0;
} beforePress;

bool opensEntry(const Context& context) {
    return context.typing && (ImGui::IsMouseDoubleClicked(0) || (ImGui::IsMouseClicked(0) && ImGui::GetIO().KeyCtrl));
}

bool isPressed(ImGuiKey key) {
#if IMGUI_VERSION_NUM < 18700
    const int index = ImGui::GetKeyIndex(key);
    return index >= 0 && ImGui::IsKeyPressed(index);
#else
    return ImGui::IsKeyPressed(key);
#endif
}

/// Way that the arrow keys move the chosen slider's handle: 1 up, -1 down, 0 not.
int arrowsOnSlider() {
    return static_cast<int>(isPressed(ImGuiKey_RightArrow)) - static_cast<int>(isPressed(ImGuiKey_LeftArrow));
}

/// Value a fiftieth of the slider's length farther, or the next one if they are coarser.
double steppedValue(const Scale& scale, bool whole, double value, int way) {
    constexpr double kStep = 0.02;
    for (double share = kStep; share < 1 + kStep; share += kStep) {
        const double next =
            scale.rounded(scale.fromShare(std::clamp(scale.toShare(value) + way * share, 0.0, 1.0)), whole);
        if (next != value) return next;
    }
    return value;
}

/// Draws a thin track with a round handle. A double click, Ctrl and click, or Enter opens the text field.
bool slider(Context& context, std::string_view name, const Scale& scale, bool whole, double& value) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = context.points(20);
    const float radius = context.points(8);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton("##slider", {width, height});
    markItem(context, name);
    const bool byMouse = ImGui::IsMouseDown(0) || ImGui::IsMouseReleased(0);
    const bool byKeys = !byMouse && ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
    const bool held = ImGui::IsItemActive() && byMouse;
    const bool hovered = ImGui::IsItemHovered();
    const float length = width - 2 * radius;
    bool changed = false;
    if (hovered && opensEntry(context)) {
        if (ImGui::IsMouseDoubleClicked(0) && beforePress.name == name) value = beforePress.value;
        entry.open(name, value);
        changed = true;
    } else if (byKeys && pressed) {
        entry.open(name, value);
    } else if (const int way = byKeys ? arrowsOnSlider() : 0; way != 0) {
        const double wanted = steppedValue(scale, whole, value, way);
        changed = wanted != value;
        value = wanted;
    } else if (held) {
        if (ImGui::IsItemActivated()) {
            beforePress.name = name;
            beforePress.value = value;
            entry.forget();
        }
        const float along = (ImGui::GetIO().MousePos.x - corner.x - radius) / length;
        const double share = static_cast<double>(std::clamp(along, 0.0f, 1.0f));
        const double wanted = scale.rounded(scale.fromShare(share), whole);
        changed = wanted != value;
        value = wanted;
    }

    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float middle = corner.y + height / 2;
    const float thick = context.points(2);
    const float at = corner.x + radius + length * static_cast<float>(scale.toShare(value));
    fillRounded(*draw, {corner.x, middle - thick}, {corner.x + width, middle + thick}, colour::kTrack, thick);
    fillRounded(*draw, {corner.x, middle - thick}, {at, middle + thick}, colour::kAccent, thick);
    draw->AddCircleFilled({at, middle}, radius, held ? colour::kAccent : IM_COL32(245, 247, 250, 255), 24);
    if (hovered || held) draw->AddCircle({at, middle}, radius + context.points(2), IM_COL32(255, 138, 61, 150), 24, 2);
    return changed;
}

/// True if the person clicks the place of the last item, which is no stop for keys.
bool clickedByMouse() {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const auto within = [&](ImVec2 p) { return p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y; };
    const ImGuiIO& io = ImGui::GetIO();
    return within(io.MousePos) && within(io.MouseClickedPos[0]) && ImGui::IsMouseReleased(0) &&
           ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

/// True if Backspace or Delete is pressed at the slider that keys have chosen.
bool givesBackByKey() {
    if (!ImGui::GetIO().NavVisible || !ImGui::IsItemFocused()) return false;
    return isPressed(ImGuiKey_Backspace) || isPressed(ImGuiKey_Delete);
}

/// Draws a control's value; returns true if the person clicks it to type another. Keys use the slider instead, so it is
/// no control of its own.
bool valueText(Context& context, std::string_view name, std::string_view value, bool typed) {
    const char* const end = value.data() + value.size();
    const ImVec2 low = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(value.data(), end);
    const float margin = context.points(6); // a single digit alone is hard to hit
    const auto within = [&](ImVec2 p) {
        return p.x >= low.x - margin && p.x < low.x + size.x + margin && p.y >= low.y && p.y < low.y + size.y;
    };
    const ImGuiIO& io = ImGui::GetIO();
    const bool pointed = typed && context.typing && within(io.MousePos) &&
                         ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ImGui::PushStyleColor(ImGuiCol_Text, pointed ? colour::kAccent : colour::kQuiet);
    ImGui::TextUnformatted(value.data(), end);
    ImGui::PopStyleColor();
    if (!typed || !context.typing) return false;
    markItem(context, ShortText{name, ".value"});
    tooltip(context, phrase("control.type"));
    return pointed && ImGui::IsMouseReleased(0) && within(io.MouseClickedPos[0]);
}

enum class LabelPress { none, back, value };

/// Draws the label at the left, value and unit at the right, and the button for the first value in between. `typed`:
/// a click on the value opens a text field.
LabelPress labelLine(Context& context, std::string_view name, std::string_view table, const Parameter& p,
                     std::string_view value, std::string_view original, bool typed = false) {
    const float left = ImGui::GetCursorPosX();
    const float right = left + ImGui::GetContentRegionAvail().x;
    ImGui::PushTextWrapPos(0);
    const std::string_view label = translatedLabel(table, p);
    ImGui::TextUnformatted(label.data(), label.data() + label.size());
    ImGui::PopTextWrapPos();
    if (ImGui::IsItemHovered()) tooltip(context, description(table, p, original));
    bool back = false;
    const float width = ImGui::CalcTextSize(value.data(), value.data() + value.size()).x;
    const float size = context.points(18);
    const bool changed = !original.empty() && original != parameterText(p);
    const float need = width + (changed ? size + context.points(6) : 0);
    // The value goes below its label if both are too long for one line.
    const bool beside = left + ImGui::GetItemRectSize().x + context.points(4) <= right - need;
    if (changed) {
        if (beside) ImGui::SameLine();
        ImGui::SetCursorPosX(std::max(right - need, left));
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ImGui::Dummy({size, ImGui::GetTextLineHeight()});
        back = clickedByMouse();
        markItem(context, ShortText{name, ".back"});
        const ImU32 tint = ImGui::IsItemHovered() ? colour::kAccent : colour::kQuiet;
        ShortText note;
        appendPhrase(note, "control.back_to", {{"value", inItsUnit(table, p, original)}});
        tooltip(context, note);
        const ImVec2 centre{corner.x + size / 2, corner.y + ImGui::GetTextLineHeight() / 2};
        const float r = context.points(5);
        ImDrawList* draw = ImGui::GetWindowDrawList();
        draw->PathArcTo(centre, r, -2.6f, 2.4f, 16);
        draw->PathStroke(tint, 0, context.points(1.6f));
        const ImVec2 end{centre.x + r * std::cos(-2.6f), centre.y + r * std::sin(-2.6f)};
        draw->AddTriangleFilled({end.x - r * 0.75f, end.y + r * 0.15f}, {end.x + r * 0.65f, end.y + r * 0.55f},
                                {end.x - r * 0.25f, end.y - r * 1.0f}, tint);
    }
    if (!value.empty()) {
        if (beside || changed) ImGui::SameLine();
        ImGui::SetCursorPosX(std::max(right - width, left));
        if (valueText(context, name, value, typed)) return LabelPress::value;
    }
    return back ? LabelPress::back : LabelPress::none;
}

bool isBareUnit(std::string_view unit) {
    return unit.empty() || unit == "1" || unit == "-";
}

ShortText valueWithUnit(const Parameter& p, double value) {
    if (isBareUnit(p.unit)) return niceNumber(value);
    const ShownUnit unit = shownUnit(p.unit);
    double shown = value * unit.perMetric;
    if (unit.converts() && shown != 0) { // three digits: a metric round number has many in inches
        const double grain = std::pow(10, std::floor(std::log10(std::abs(shown))) - 2);
        shown = std::round(shown / grain) * grain;
    }
    return {niceNumber(shown), " ", unit.name};
}

/// Text of the value in menus, with its unit.
ShortText givenText(std::string_view table, const Parameter& p) {
    if (const auto* value = std::get_if<float*>(&p.value)) return valueWithUnit(p, static_cast<double>(**value));
    if (const auto* value = std::get_if<int*>(&p.value))
        return p.choices.empty() ? valueWithUnit(p, **value)
                                 : ShortText(shownText(table, p, p.choices[static_cast<size_t>(**value)]));
    return std::string_view(parameterText(p)); // processes have no other types
}

struct Draw {
    Context& context;
    std::string_view name;
    std::string_view table; ///< table of its phrases
    const Parameter& p;
    std::string_view original;

    bool number(double& value, bool whole) const {
        const LabelPress press = labelLine(context, name, table, p, valueWithUnit(p, value), original, true);
        if (press == LabelPress::back) {
            entry.forget();
            setParameter({p}, p.key, original, p.key);
            return false; // typed values are set at full precision
        }
        const ShownUnit unit = shownUnit(p.unit);
        const Scale scale(p, unit, original);
        double shown = value * unit.perMetric;
        if (press == LabelPress::value) entry.open(name, shown);
        bool changed = false;
        if (!entry.isOpen(name)) {
            changed = slider(context, name, scale, whole, shown);
            if (!original.empty() && givesBackByKey()) {
                setParameter({p}, p.key, original, p.key);
                return false;
            }
        } else if (const auto typed = entry.draw(
                       {scale.low, scale.high, whole, isBareUnit(p.unit) ? std::string_view() : unit.name})) {
            shown = *typed;
            changed = true;
        }
        if (entry.refused(name)) entry.drawRefusal(context, name, allowedText(table, p));
        // A double click gives the value back that it had: exactly, also in inches.
        if (changed) value = unit.converts() ? std::clamp(shown / unit.perMetric, p.minimum, p.maximum) : shown;
        return changed;
    }
    bool operator()(float* target) const {
        const float before = *target;
        double value = static_cast<double>(before);
        if (number(value, false)) *target = static_cast<float>(value);
        return *target != before;
    }
    bool operator()(int* target) const {
        const int before = *target;
        if (p.choices.empty()) {
            double value = before;
            if (number(value, true)) *target = static_cast<int>(value);
            return *target != before;
        }
        if (labelLine(context, name, table, p, "", original) == LabelPress::back)
            setParameter({p}, p.key, original, p.key);
        choiceRow(context, name, p.choices, *target, choiceWords(table, p), p.choiceNames);
        return *target != before;
    }
    bool operator()(bool* target) const {
        bool hovered = false;
        const bool changed = toggle(context, name, translatedLabel(table, p), *target, nullptr, &hovered);
        if (hovered) tooltip(context, description(table, p, original));
        return changed;
    }
    bool operator()(glm::vec3* target) const {
        const glm::vec3 before = *target;
        if (labelLine(context, name, table, p, isBareUnit(p.unit) ? std::string_view() : p.unit, original) ==
            LabelPress::back)
            setParameter({p}, p.key, original, p.key);
        ImGui::SetNextItemWidth(-1);
        const float speed = static_cast<float>(std::min(p.maximum - p.minimum, 40.0) / 400);
        const float low = static_cast<float>(p.minimum);
        const float high = static_cast<float>(p.maximum);
        ImGui::DragScalarN("##vector", ImGuiDataType_Float, &target->x, 3, speed, &low, &high, "%.2f",
                           ImGuiSliderFlags_AlwaysClamp);
        markItem(context, name);
        return *target != before;
    }
    bool operator()(std::string* target) const {
        labelLine(context, name, table, p, "", original);
        quietText(context, *target);
        return false;
    }
};

bool control(Context& context, std::string_view prefix, std::string_view table, const Parameter& parameter,
             const DefaultTexts& defaults) {
    const ShortText name{prefix, ".", parameter.key};
    const auto known = defaults.find(parameter.key);
    const std::string_view original = known == defaults.end() ? std::string_view() : known->second;
    ImGui::PushID(name.c_str());
    ImGui::BeginGroup();
    const bool changed = std::visit(Draw{context, name, table, parameter, original}, parameter.value);
    ImGui::EndGroup();
    ImGui::PopID();
    return changed;
}

} // namespace

bool parameterControl(Context& context, std::string_view prefix, const Parameter& parameter,
                      const DefaultTexts& defaults) {
    return control(context, prefix, prefix, parameter, defaults);
}

bool parameterControl(Context& context, const ParameterSection& section, const Parameter& parameter) {
    const std::string_view table = section.words;
    if (!section.isGiven(parameter)) return control(context, section.name, table, parameter, section.defaults);
    const ShortText name{section.name, ".", parameter.key, ".given"};
    ImGui::PushID(name.c_str());
    ImGui::BeginGroup();
    ShortText given;
    appendPhrase(given, "control.given", {{"value", givenText(table, parameter)}});
    labelLine(context, name, table, parameter, given, {});
    ImGui::EndGroup();
    markItem(context, name);
    ImGui::PopID();
    return false;
}

} // namespace meltpool::ui
