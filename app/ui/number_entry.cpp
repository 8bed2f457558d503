#include "app/ui/number_entry.hpp"

#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace meltpool::ui {

std::optional<double> typedNumber(std::string_view typed, std::string_view unit) {
    std::string text(trimText(typed));
    if (!unit.empty() && text.size() > unit.size() && text.ends_with(unit))
        text = trimText(std::string_view(text).substr(0, text.size() - unit.size()));
    std::replace(text.begin(), text.end(), ',', '.');
    const auto number = parseDouble(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

bool NumberRange::takes(double value) const {
    return value >= low && value <= high && (!whole || value == std::round(value));
}

void NumberEntry::open(std::string_view name, double value) {
    name_ = name;
    std::snprintf(first_, sizeof first_, "%s", withDecimalMark(formatNumber(static_cast<float>(value))).c_str());
    std::memcpy(text_, first_, sizeof text_);
    fresh_ = true;
    frame_ = ImGui::GetFrameCount();
    forget();
}

bool NumberEntry::isOpen(std::string_view name) const {
    const int since = ImGui::GetFrameCount() - frame_;
    return name_ == name && since >= 0 && since <= 1;
}

std::optional<double> NumberEntry::draw(const NumberRange& range) {
    frame_ = ImGui::GetFrameCount();
    if (fresh_) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputText("##typed", text_, sizeof text_,
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    const bool left = !fresh_ && ImGui::IsItemDeactivated();
    fresh_ = false;
    if (!entered && !left) return {};
    // Dear ImGui puts the first text back on Escape.
    const bool same = std::string_view(text_) == first_;
    const auto number = same ? std::nullopt : typedNumber(text_, range.unit);
    const bool taken = number && range.takes(*number);
    const std::string_view at = name_;
    if (same || taken) forget();
    if (!same && !taken) {
        refusedAt_ = at;
        refusedText_ = text_;
    }
    fresh_ = entered && !same && !taken;
    if (!fresh_) name_.clear();
    return taken ? number : std::nullopt;
}

void NumberEntry::drawRefusal(Context& context, std::string_view name, std::string_view allowed) const {
    if (!refused(name)) return;
    ImGui::PushStyleColor(ImGuiCol_Text, colour::kWarning);
    wrappedText(phrase("control.refused", {{"text", refusedText_}, {"allowed", allowed}}));
    ImGui::PopStyleColor();
    markItem(context, ShortText{name, ".refused"});
}

} // namespace meltpool::ui
