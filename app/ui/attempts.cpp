// Draws the list of saved attempts, with the buttons of each.
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cstdio>

namespace meltpool::ui {

namespace {

constexpr float kButtonsWidth = 60 + 66 + 84 + 4 * 6; ///< points, with their gaps

/// Draws the attempt's title and facts, one above the other, cut off at the buttons.
void entryText(Context& context, const Home& home, const ReplayEntry& entry, float height) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    // A narrow window has the buttons below the text.
    const bool beside = ImGui::GetContentRegionAvail().x > context.points(2 * kButtonsWidth);
    const float width = ImGui::GetContentRegionAvail().x - (beside ? context.points(kButtonsWidth) : 0);
    const ImVec2 high{low.x + width, low.y + height};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const CataloguedLesson* lesson = home.find(entry.lesson);
    const std::string& title = lesson == nullptr ? entry.lesson : lesson->title;
    const float scale = ImGui::GetIO().FontGlobalScale;
    ImFont *strong = context.fonts.strong, *small = context.fonts.small;
    draw.PushClipRect(low, high, true);
    draw.AddText(strong, loadedSize(*strong) * scale, low, colour::kText, title.c_str());
    draw.AddText(small, loadedSize(*small) * scale, {low.x, high.y - loadedSize(*small) * scale}, colour::kQuiet,
                 entry.detail.c_str());
    draw.PopClipRect();
    ImGui::Dummy({width, height});
    if (beside) ImGui::SameLine(0, context.points(6));
}

/// Makes a name such as "home.attempt.3.play".
ShortText nameOf(size_t index, const char* what) {
    char name[60];
    std::snprintf(name, sizeof name, "home.attempt.%zu.%s", index, what);
    return name;
}

MenuRequest entryRow(Context& context, Home& home, size_t index) {
    ReplayList& list = home.attempts;
    const ReplayEntry& entry = list.entries()[index];
    const float words =
        (loadedSize(*context.fonts.strong) + loadedSize(*context.fonts.small)) * ImGui::GetIO().FontGlobalScale;
    entryText(context, home, entry, words + context.points(4));
    MenuRequest request = MenuRequest::none;
    ButtonRow row(context);
    if (row.add(nameOf(index, "play"), phrase("attempts.play").c_str(), ButtonKind::plain, 60,
                phrase("attempts.play_tip").c_str()))
        request = MenuRequest::replay;
    if (row.add(nameOf(index, "ghost"), phrase("attempts.ghost").c_str(), ButtonKind::plain, 66,
                phrase("attempts.ghost_tip").c_str()))
        request = MenuRequest::ghost;
    if (row.add(nameOf(index, "compare"), phrase("attempts.compare").c_str(),
                list.marked(index) ? ButtonKind::lit : ButtonKind::plain, 84, phrase("attempts.compare_tip").c_str()) &&
        list.mark(index))
        return MenuRequest::compare;
    if (request != MenuRequest::none) list.choose(index);
    return request;
}

void pageButtons(Context& context, ReplayList& list, size_t pages) {
    if (button(context, "home.attempts.newer", phrase("attempts.newer").c_str(), ButtonKind::plain, 100) &&
        list.page > 0)
        --list.page;
    ImGui::SameLine();
    if (button(context, "home.attempts.older", phrase("attempts.older").c_str(), ButtonKind::plain, 100) &&
        list.page + 1 < pages)
        ++list.page;
    ImGui::SameLine();
    ShortText page;
    appendPhrase(page, "attempts.page", {{"page", std::to_string(list.page + 1)}, {"pages", std::to_string(pages)}});
    quietText(context, page);
}

} // namespace

MenuRequest attemptList(Context& context, Home& home, Activities& activities, size_t rows) {
    if (activities.at(activities.comparison)) {
        comparisonPart(context, activities);
        return MenuRequest::none;
    }
    ReplayList& list = home.attempts;
    MenuRequest request = MenuRequest::none;
    if (!list.fault().empty()) quietText(context, list.fault());
    const size_t count = list.entries().size();
    if (count == 0) {
        if (list.fault().empty()) quietText(context, phrase("attempts.none"));
        return request;
    }
    if (list.marks()) {
        quietText(context, phrase("attempts.one_marked"));
        markItem(context, "home.attempts.marked");
    }
    const size_t pages = (count + rows - 1) / rows;
    list.page = std::min(list.page, pages - 1);
    for (size_t i = list.page * rows; i < std::min(count, (list.page + 1) * rows); ++i)
        if (const MenuRequest asked = entryRow(context, home, i); asked != MenuRequest::none) request = asked;
    if (pages > 1) pageButtons(context, list, pages);
    return request;
}

} // namespace meltpool::ui
