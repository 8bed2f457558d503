// Draws the saved attempts as a table that fills the window: filter, headings that sort, rows, and the buttons of the
// chosen row at the right.
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace meltpool::ui {

namespace {

constexpr float kActionsWidth = 132; ///< points
constexpr ImU32 kChosen = IM_COL32(255, 138, 61, 56);
constexpr float kGap = 12;              ///< points between two columns
constexpr float kSmallBelow = 720;      ///< points of width below which the small font is used
constexpr float kShortScoreBelow = 420; ///< points of width below which a score has no words
constexpr float kShortScoreWidth = 56;  ///< points, as those of a column

struct Column {
    AttemptColumn column;
    const char* key;  ///< of its heading, and of its control
    float width;      ///< points in the ordinary font; 0 or less: shares the rest
    float share;      ///< of the rest
    float shownAbove; ///< points of room below which the column is left out
};
constexpr std::array<Column, 6> kColumns{{{AttemptColumn::lesson, "lesson", 0, 4, 0},
                                          {AttemptColumn::title, "title", 0, 3, 460},
                                          {AttemptColumn::date, "date", 152, 0, 300},
                                          {AttemptColumn::length, "length", 84, 0, 640},
                                          {AttemptColumn::score, "score", 154, 0, 0},
                                          {AttemptColumn::test, "test", 62, 0, 400}}};

/// Places of the columns for a room.
struct Layout {
    std::array<float, kColumns.size()> left{}, width{}; ///< pixels; no width: not shown
    ImFont* font = nullptr;
    float rowHeight = 0; ///< pixels
    bool shortScore = false;
};

Layout layoutFor(const Context& context, float room) {
    Layout layout;
    const float points = room / context.scale;
    const bool small = points < kSmallBelow;
    layout.shortScore = points < kShortScoreBelow;
    layout.font = small ? context.fonts.small : context.fonts.body;
    layout.rowHeight = loadedSize(*layout.font) * ImGui::GetIO().FontGlobalScale + context.points(8);
    float fixed = 0, sharing = 0;
    for (size_t i = 0; i < kColumns.size(); ++i) {
        if (points < kColumns[i].shownAbove) continue;
        const bool shortened = layout.shortScore && kColumns[i].column == AttemptColumn::score;
        const float width = shortened ? kShortScoreWidth : kColumns[i].width;
        layout.width[i] = width > 0 ? context.points(width * (small ? 0.84f : 1)) : kColumns[i].share;
        (width > 0 ? fixed : sharing) += layout.width[i];
    }
    float left = 0;
    for (size_t i = 0; i < kColumns.size(); ++i) {
        if (kColumns[i].width <= 0) layout.width[i] *= std::max(room - fixed, context.points(60)) / sharing;
        layout.left[i] = left;
        left += layout.width[i];
    }
    return layout;
}

/// Draws a line of text at the middle of the row's height, cut off at the column's end.
void cellText(Context& context, const Layout& layout, size_t column, ImVec2 row, ImU32 tint, const char* text) {
    const float size = loadedSize(*layout.font) * ImGui::GetIO().FontGlobalScale;
    const ImVec2 low{row.x + layout.left[column] + context.points(6), row.y};
    const ImVec2 high{row.x + layout.left[column] + layout.width[column] - context.points(kGap / 2),
                      row.y + layout.rowHeight};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(low, high, true);
    const bool fits = layout.font->CalcTextSizeA(size, FLT_MAX, 0, text).x <= high.x - low.x;
    const auto cut = fits ? std::vector<std::string>() : wholeWords(*layout.font, size, text, high.x - low.x, 1);
    draw.AddText(layout.font, size, {low.x, low.y + (layout.rowHeight - size) / 2}, tint,
                 cut.empty() ? text : cut.front().c_str());
    draw.PopClipRect();
}

std::string titleOf(const Home& home, const std::string& key) {
    const CataloguedLesson* lesson = home.find(key);
    return lesson == nullptr ? key : lesson->title;
}

/// Draws a line to type in; returns true if Enter ended it.
bool textField(Context& context, const char* name, const std::string& hint, std::string& text, float width) {
    std::array<char, 128> typed{};
    text.copy(typed.data(), typed.size() - 1);
    ImGui::SetNextItemWidth(std::min(context.points(width), ImGui::GetContentRegionAvail().x));
    const bool entered =
        ImGui::InputTextWithHint(ShortText{"##", name}.c_str(), hint.c_str(), typed.data(), typed.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    markItem(context, name);
    text = typed.data();
    return entered;
}

/// Draws the choice of one lesson of the list.
void lessonChoice(Context& context, const Home& home, ReplayList& list, AttemptFilter& filter, float width) {
    const auto titles = [&](const std::string& key) { return titleOf(home, key); };
    const std::string shown = filter.lesson.empty() ? phrase("attempts.all_lessons") : titleOf(home, filter.lesson);
    ImGui::SetNextItemWidth(std::min(context.points(width), ImGui::GetContentRegionAvail().x));
    list.choosing = ImGui::BeginCombo("##home.attempts.lesson", shown.c_str());
    if (!list.choosing) return markItem(context, "home.attempts.lesson");
    const auto item = [&](const std::string& key, const std::string& title, const std::string& name) {
        if (ImGui::Selectable((title + "##" + name).c_str(), filter.lesson == key)) filter.lesson = key;
        markItem(context, name);
    };
    ImGui::PushStyleColor(ImGuiCol_Header, IM_COL32(255, 138, 61, 46));
    item({}, phrase("attempts.all_lessons"), "home.attempts.lesson.all");
    for (const auto& [key, title] : list.lessons(titles))
        item(key, title, "home.attempts.lesson." + key);
    ImGui::PopStyleColor();
    ImGui::EndCombo();
}

void filterRow(Context& context, const Home& home, ReplayList& list, size_t shown) {
    AttemptFilter filter = list.filter();
    const bool narrow = narrowerThan(context, 520);
    const float search = narrow ? 110 : 210, lesson = narrow ? 140 : 230;
    ButtonRow row(context, 10);
    row.place(search);
    // The Tab key that opened the list does not begin to type here.
    ImGui::BeginDisabled(std::exchange(list.opened, false));
    textField(context, "home.attempts.search", phrase("attempts.search"), filter.text, search);
    ImGui::EndDisabled();
    tooltip(context, phrase("attempts.search_tip"));
    row.place(lesson);
    lessonChoice(context, home, list, filter, lesson);
    if (row.add("home.attempts.tests", phrase("attempts.tests").c_str(),
                filter.testsOnly ? ButtonKind::lit : ButtonKind::plain, 96, phrase("attempts.tests_tip").c_str()))
        filter.testsOnly = !filter.testsOnly;
    list.setFilter(std::move(filter));
    if (narrow) return;
    ShortText count;
    appendPhrase(count, "attempts.count",
                 {{"shown", std::to_string(shown)}, {"all", std::to_string(list.entries().size())}});
    row.place(70);
    ImGui::AlignTextToFramePadding();
    quietLine(context, count);
}

/// Draws the sign of the direction behind a heading.
void directionSign(Context& context, ImVec2 at, bool ascending) {
    const float r = context.points(4), up = ascending ? -1.0f : 1.0f;
    ImGui::GetWindowDrawList()->AddTriangleFilled({at.x - r, at.y - up * r / 2}, {at.x + r, at.y - up * r / 2},
                                                  {at.x, at.y + up * r}, colour::kAccent);
}

void headings(Context& context, ReplayList& list, const Layout& layout) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const AttemptOrder order = list.order();
    for (size_t i = 0; i < kColumns.size(); ++i) {
        if (layout.width[i] <= 0) continue;
        const std::string name = std::string("home.attempts.column.") + kColumns[i].key;
        const ShortText key{"attempts.column.", kColumns[i].key};
        ImGui::SetCursorScreenPos({corner.x + layout.left[i], corner.y});
        const bool sorts = order.column == kColumns[i].column;
        if (ImGui::Selectable(("##" + name).c_str(), false, 0, {layout.width[i] - context.points(2), layout.rowHeight}))
            list.press(kColumns[i].column);
        markItem(context, name);
        tooltip(context, phrase("attempts.column.tip"));
        const std::string& text = phrase(key);
        cellText(context, layout, i, corner, sorts ? colour::kText : colour::kQuiet, text.c_str());
        if (!sorts) continue;
        const float size = loadedSize(*layout.font) * ImGui::GetIO().FontGlobalScale;
        const float words = layout.font->CalcTextSizeA(size, 1e6f, 0, text.c_str()).x;
        directionSign(context,
                      {corner.x + layout.left[i] + words + context.points(16), corner.y + layout.rowHeight / 2},
                      order.ascending);
    }
    ImGui::SetCursorScreenPos({corner.x, corner.y + layout.rowHeight + context.points(2)});
    ImGui::Separator();
}

ImU32 scoreTint(const ReplayEntry& entry) {
    if (entry.practice || !entry.score) return colour::kQuiet;
    if (entry.verdict.empty()) return colour::kText;
    return entry.verdict == "accepted" ? IM_COL32(134, 214, 140, 255) : IM_COL32(255, 138, 120, 255);
}

/// Returns score and sign of an accepted weld, for a column without room for words; the row's tip has them.
std::string shortScoreText(const ReplayEntry& entry) {
    const std::string score = entry.score ? std::to_string(*entry.score) : "\xE2\x80\x93";
    return !entry.practice && entry.verdict == "accepted" ? score + " \xE2\x9C\x93" : score;
}

/// Shows lesson, name and score whole if their columns cut them off.
void rowTip(Context& context, const Layout& layout, const ReplayEntry& entry) {
    const float size = loadedSize(*layout.font) * ImGui::GetIO().FontGlobalScale;
    const auto cut = [&](size_t column, const std::string& text) {
        const float words = layout.font->CalcTextSizeA(size, 1e6f, 0, text.c_str()).x;
        return !text.empty() && words > layout.width[column] - context.points(kGap);
    };
    if (!layout.shortScore && !cut(0, entry.lessonTitle) && !cut(1, entry.title)) return;
    std::string text = entry.lessonTitle;
    if (!entry.title.empty()) text += "\n" + entry.title;
    if (layout.shortScore) text += "\n" + entry.when + "\n" + scoreText(entry);
    tooltip(context, text);
}

/// Draws the row at `place` of the list; returns true if it is to be played.
bool attemptRow(Context& context, ReplayList& list, const Layout& layout, size_t index, size_t place) {
    const ReplayEntry& entry = list.entries()[index];
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    if (place % 2 == 1)
        fillRounded(*ImGui::GetWindowDrawList(), low, {low.x + width, low.y + layout.rowHeight},
                    IM_COL32(255, 255, 255, 7), 0);
    char name[40];
    std::snprintf(name, sizeof name, "home.attempt.%zu", place);
    const bool chosen = list.selected() == index;
    ImGui::PushStyleColor(ImGuiCol_HeaderHovered, chosen ? kChosen : IM_COL32(255, 255, 255, 14));
    const bool pressed = ImGui::Selectable(ShortText{"##", name}.c_str(), chosen, ImGuiSelectableFlags_AllowDoubleClick,
                                           {0, layout.rowHeight});
    ImGui::PopStyleColor();
    markItem(context, name);
    if (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible) {
        list.select(index);
        list.rowFocused = true;
    }
    if (pressed) list.select(index);
    if (!ImGui::IsItemVisible()) return false;
    if (ImGui::IsItemHovered()) rowTip(context, layout, entry);
    if (list.marked(index))
        fillRounded(*ImGui::GetWindowDrawList(), low, {low.x + context.points(3), low.y + layout.rowHeight},
                    colour::kCold, 0);
    const auto cell = [&](size_t column, const std::string& text, ImU32 tint) {
        if (layout.width[column] > 0) cellText(context, layout, column, low, tint, text.c_str());
    };
    cell(0, entry.lessonTitle, colour::kText);
    cell(1, entry.title, colour::kText);
    cell(2, entry.when, colour::kQuiet);
    cell(3, lengthText(entry.seconds), colour::kQuiet);
    cell(4, layout.shortScore ? shortScoreText(entry) : scoreText(entry), scoreTint(entry));
    if (entry.test) cell(5, phrase("attempts.column.test"), colour::kAccent);
    return pressed && ImGui::IsMouseDoubleClicked(0);
}

MenuRequest rowsPart(Context& context, ReplayList& list, const std::vector<size_t>& rows, const Layout& layout) {
    MenuRequest request = MenuRequest::none;
    beginPart("attempts.rows", {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_Header, kChosen);
    list.rowFocused = false;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), layout.rowHeight);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const size_t place = static_cast<size_t>(i), index = rows[place];
            if (!attemptRow(context, list, layout, index, place)) continue;
            list.choose(index);
            request = MenuRequest::replay;
        }
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    ImGui::EndChild();
    markItem(context, "home.attempts.rows");
    return request;
}

/// Draws the question before a removal, or the line for a new name, below the button that was pressed.
void askingPart(Context& context, ReplayList& list, size_t index) {
    const ReplayEntry& entry = list.entries()[index];
    if (list.asking == ReplayList::Asking::removal) {
        wrappedText(phrase("attempts.question", {{"lesson", entry.lessonTitle}, {"date", entry.when}}));
        ButtonRow row(context);
        const bool yes = row.add("home.attempts.delete.yes", phrase("attempts.delete_yes").c_str());
        const bool no = row.add("home.attempts.delete.no", phrase("attempts.delete_no").c_str());
        if (yes || no) list.asking = ReplayList::Asking::nothing;
        if (yes) list.remove(index);
        return;
    }
    ButtonRow row(context);
    row.place(300);
    if (std::exchange(list.fresh, false)) ImGui::SetKeyboardFocusHere();
    const bool entered = textField(context, "home.attempts.title", phrase("attempts.title_hint"), list.typed, 300);
    const bool kept = row.add("home.attempts.title.keep", phrase("attempts.title_keep").c_str(), ButtonKind::main);
    const bool left = row.add("home.attempts.title.cancel", phrase("attempts.title_cancel").c_str());
    if (entered || kept || left) list.asking = ReplayList::Asking::nothing;
    if (entered || kept) list.rename(index, list.typed);
}

/// Draws what the list has done.
void noticePart(Context& context, ReplayList& list) {
    if (!list.fault().empty()) quietText(context, list.fault());
    if (!list.notice().empty()) quietText(context, list.notice());
    if (list.canBringBack() && button(context, "home.attempts.undo", phrase("attempts.undo").c_str())) list.bringBack();
    if (!list.marks()) return;
    quietText(context, phrase("attempts.one_marked"));
    markItem(context, "home.attempts.marked");
}

/// Draws the buttons of the chosen row, one below the other.
MenuRequest actionsPart(Context& context, ReplayList& list, std::optional<size_t> selected) {
    using Asking = ReplayList::Asking;
    MenuRequest request = MenuRequest::none;
    const auto press = [&](const char* name, const char* text, const char* tip, ButtonKind kind) {
        return button(context, name, phrase(text).c_str(), kind, kActionsWidth, phrase(tip).c_str());
    };
    const auto asks = [&](Asking what) {
        if (list.asking == what) askingPart(context, list, *selected);
    };
    if (selected) {
        if (press("home.attempts.play", "attempts.play", "attempts.play_tip", ButtonKind::main))
            request = MenuRequest::replay;
        if (press("home.attempts.ghost", "attempts.ghost", "attempts.ghost_tip", ButtonKind::plain))
            request = MenuRequest::ghost;
        if (press("home.attempts.compare", "attempts.compare", "attempts.compare_tip",
                  list.marked(*selected) ? ButtonKind::lit : ButtonKind::plain) &&
            list.mark(*selected))
            request = MenuRequest::compare;
        if (press("home.attempts.page", "attempts.show_page", "attempts.show_page_tip", ButtonKind::plain))
            request = MenuRequest::keptPage;
        if (press("home.attempts.name", "attempts.name", "attempts.name_tip", ButtonKind::plain)) {
            list.asking = Asking::title;
            list.typed = list.entries()[*selected].title;
            list.fresh = true;
        }
        asks(Asking::title);
        if (press("home.attempts.delete", "attempts.delete", "attempts.delete_tip", ButtonKind::plain))
            list.asking = Asking::removal;
        asks(Asking::removal);
        if (request != MenuRequest::none && request != MenuRequest::compare) list.choose(*selected);
    }
    ImGui::Dummy({0, context.points(6)});
    if (press("home.attempts.export", "attempts.export", "attempts.export_tip", ButtonKind::plain))
        request = MenuRequest::exportAttempts;
    return request;
}

} // namespace

MenuRequest attemptTable(Context& context, Home& home, Activities& activities) {
    if (activities.at(activities.comparison)) {
        comparisonPart(context, activities);
        return MenuRequest::none;
    }
    ReplayList& list = home.attempts;
    const auto titles = [&](const std::string& key) { return titleOf(home, key); };
    if (list.entries().empty()) {
        noticePart(context, list);
        if (list.fault().empty()) quietText(context, phrase("attempts.none"));
        return MenuRequest::none;
    }
    filterRow(context, home, list, list.rows(titles).size());
    const std::vector<size_t> rows = list.rows(titles); // a press may change the list's own
    const float room = ImGui::GetContentRegionAvail().x - context.points(kActionsWidth + kGap);
    // Below the table, so that no button moves away from the pointer.
    const float below = context.attemptsNotice > 0 ? -context.attemptsNotice - ImGui::GetStyle().ItemSpacing.y : 0;
    beginPart("attempts.table", {room, below});
    const Layout layout = layoutFor(context, ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize);
    headings(context, list, layout);
    MenuRequest request = rowsPart(context, list, rows, layout);
    if (rows.empty()) quietText(context, phrase("attempts.no_match"));
    ImGui::EndChild();
    ImGui::SameLine(0, context.points(kGap));
    beginPart("attempts.actions", {0, below});
    const MenuRequest asked = actionsPart(context, list, rows.empty() ? std::nullopt : list.selected());
    if (asked != MenuRequest::none) request = asked;
    ImGui::EndChild();
    const float top = ImGui::GetCursorPosY();
    noticePart(context, list);
    context.attemptsNotice = std::max(ImGui::GetCursorPosY() - top - ImGui::GetStyle().ItemSpacing.y, 0.0f);
    return request;
}

} // namespace meltpool::ui
