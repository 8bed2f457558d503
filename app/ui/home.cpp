// Draws the home page: the lessons with picture, level and best score, in the window and on the headset's panel.
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cfloat>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool::ui {

namespace {

constexpr float kTileWidth = 214;    ///< points, the least in the window
constexpr float kWidestTile = 300;   ///< points
constexpr float kRowHeight = 70;     ///< points, of a lesson on the headset's panel and in a low window
constexpr float kRowWidth = 300;     ///< points, the least in a low window
constexpr float kLowWindow = 420;    ///< points
constexpr size_t kRowsAPage = 4;     ///< rows on the headset's panel
constexpr size_t kAttemptsOnPanel = 6;
constexpr float kPictureShape = 16.0f / 9;

/// Draws a place without a picture: the logo on a dark ground.
void drawPlainTile(ImDrawList& draw, ImVec2 low, ImVec2 high) {
    fillRounded(draw, low, high, colour::kTrack, 0);
    drawSign(draw, {(low.x + high.x) / 2, (low.y + high.y) / 2}, (high.y - low.y) * 0.5f);
}

/// Draws the reason why the lesson cannot be used, in the place of its picture or its level.
void drawFault(Context& context, const CataloguedLesson& lesson, ImVec2 low, ImVec2 high) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float size = loadedSize(*context.fonts.small) * ImGui::GetIO().FontGlobalScale;
    draw.PushClipRect(low, high, true);
    draw.AddText(context.fonts.small, size, low, colour::kWarning, shortFault(lesson).c_str(), nullptr,
                 high.x - low.x - context.points(8));
    draw.PopClipRect();
}

/// Draws wholeWords(). `leftBottom`: lower left end of the last line.
void drawWords(ImFont* font, float size, ImVec2 leftBottom, ImU32 tint, std::string_view text, float width,
               size_t lines) {
    const std::vector<std::string> broken = wholeWords(*font, size, text, width, lines);
    float top = leftBottom.y - size * static_cast<float>(broken.size());
    for (const std::string& line : broken) {
        ImGui::GetWindowDrawList()->AddText(font, size, {leftBottom.x, top}, tint, line.c_str());
        top += size;
    }
}

/// Draws the lesson's picture and words; the words are below the picture, or next to it.
void drawLesson(Context& context, Home& home, const CataloguedLesson& lesson, ImVec2 low, ImVec2 high, bool beside) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float pad = context.points(8);
    const float height = beside ? high.y - low.y - 2 * pad : (high.x - low.x) / kPictureShape;
    const ImVec2 corner = beside ? ImVec2{low.x + pad, low.y + pad} : low;
    const ImVec2 end{corner.x + height * kPictureShape, corner.y + height};
    const bool usable = lesson.fault.empty();
    if (!usable && !beside)
        drawFault(context, lesson, {corner.x + pad, corner.y + pad}, end);
    else if (const GLuint picture = home.pictures.texture(lesson.picture); picture != 0)
        drawPicture(draw, picture, corner, end);
    else
        drawPlainTile(draw, corner, end);

    const ImVec2 at = beside ? ImVec2{end.x + pad, low.y + pad} : ImVec2{low.x + pad, end.y + pad / 2};
    const float width = high.x - pad - at.x;
    const float scale = ImGui::GetIO().FontGlobalScale;
    ImFont* strong = context.fonts.strong;
    ImFont* small = context.fonts.small;
    const float line = loadedSize(*strong) * scale;
    const float quiet = loadedSize(*small) * scale;
    draw.PushClipRect(at, {high.x - pad / 2, high.y}, true);
    draw.AddText(strong, line, at, colour::kText, lesson.title.c_str(), nullptr, width);
    if (!usable && beside) drawFault(context, lesson, {at.x, at.y + line}, high);
    const std::string standing = usable ? home.standing(lesson) : phrase("home.at_fault");
    const float under = high.y - pad - at.y - strong->CalcTextSizeA(line, FLT_MAX, width, lesson.title.c_str()).y;
    if (usable || !beside)
        drawWords(small, quiet, {at.x, high.y - pad}, usable ? colour::kQuiet : colour::kWarning, standing, width,
                  under < 2 * quiet ? 1 : 2);
    draw.PopClipRect();
}

/// Draws one lesson of the list; returns true if it was chosen. `byKeys`: keys choose too, so the chosen one is marked.
bool lessonTile(Context& context, Home& home, size_t index, ImVec2 size, bool beside, bool byKeys) {
    const CataloguedLesson& lesson = home.lessons()[index];
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + size.x, low.y + size.y};
    const std::string name = "home.lesson." + (lesson.taken ? lesson.file.string() : lesson.key);
    const bool clicked = ImGui::InvisibleButton(name.c_str(), size);
    markItem(context, name);
    const bool hovered = ImGui::IsItemHovered(), visible = ImGui::IsItemVisible();
    if (hovered) tooltip(context, lesson.fault.empty() ? lesson.text : lesson.fault);
    if (clicked) home.choose(index);
    if (!visible) return clicked;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    fillRounded(draw, low, high, hovered ? colour::kFieldHot : colour::kField, context.points(4));
    drawLesson(context, home, lesson, low, high, beside);
    const bool chosen = byKeys && index == home.chosenIndex();
    if (chosen && !home.attempts.shown()) context.focus = name;
    if (chosen || hovered)
        outlineRounded(draw, low, high, chosen ? colour::kAccent : colour::kQuiet, context.points(4));
    return clicked;
}

/// Draws the lessons in rows. A tile does not fit into a low window, so the words are next to the pictures there.
bool lessonGrid(Context& context, Home& home) {
    const bool beside = lowerThan(context, kLowWindow);
    const float gap = context.points(beside ? 8 : 14);
    const float room = ImGui::GetContentRegionAvail().x;
    const float fits = (room + gap) / (context.points(beside ? kRowWidth : kTileWidth) + gap);
    home.columns = static_cast<size_t>(std::max(1.0f, fits));
    const auto columns = static_cast<float>(home.columns);
    const float share = (room - gap * (columns - 1)) / columns;
    const float width = beside ? share : std::min(share, context.points(kWidestTile));
    const float words = 2 * loadedSize(*context.fonts.strong) + 2 * loadedSize(*context.fonts.small);
    const float height = width / kPictureShape + words * ImGui::GetIO().FontGlobalScale + context.points(20);
    const ImVec2 size{width, beside ? context.points(kRowHeight) : height};
    const bool moved = home.takeMoved();
    bool chosen = false;
    const std::vector<Home::Group> groups = home.groups();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
    for (const Home::Group& group : groups) {
        if (groups.size() > 1) strongText(context, headingOf(group.origin));
        for (size_t i = group.begin; i < group.end; ++i) {
            if ((i - group.begin) % home.columns != 0) ImGui::SameLine();
            chosen = lessonTile(context, home, i, size, beside, true) || chosen;
            if (moved && i == home.chosenIndex()) ImGui::SetScrollHereY();
        }
    }
    ImGui::PopStyleVar();
    return chosen;
}

/// Page of the headset's list: lessons of one group.
struct HomePage {
    LessonOrigin origin;
    size_t begin, end;
};

std::vector<HomePage> pagesOf(const Home& home) {
    std::vector<HomePage> pages;
    for (const Home::Group& group : home.groups())
        for (size_t i = group.begin; i < group.end; i += kRowsAPage)
            pages.push_back({group.origin, i, std::min(i + kRowsAPage, group.end)});
    return pages;
}

/// Draws the button between the lessons and the saved attempts.
void attemptsButton(Context& context, Home& home, const Activities& activities) {
    const bool shown = home.attempts.shown();
    if (activities.at(activities.comparison)) return; // the comparison has its own way back
    if (!button(context, "home.attempts", phrase(shown ? "home.lessons" : "home.attempts").c_str(), ButtonKind::plain,
                100, phrase(shown ? "home.lessons_tip" : "home.attempts_tip").c_str()))
        return;
    if (shown)
        home.attempts.hide();
    else
        home.attempts.show();
}

/// Keys of the page's heading and of the sentence below it.
struct HomeWords {
    const char* heading;
    const char* hint;
};

HomeWords wordsOf(const Context& context, const Home& home, const Activities& activities) {
    if (home.who.asked()) return {"persons.heading", "persons.hint"};
    if (!home.attempts.shown())
        return {"home.lessons", context.byGamepad ? "home.lessons_hint_pad" : "home.lessons_hint"};
    if (activities.at(activities.comparison)) return {"home.two_attempts", "home.two_attempts_hint"};
    return {"home.attempts", "home.attempts_hint"};
}

} // namespace

void drawPicture(ImDrawList& draw, GLuint texture, ImVec2 low, ImVec2 high) {
    draw.AddImage((ImTextureID)(intptr_t)texture, low, high); // NOLINT: a pointer or a number by Dear ImGui's version
    outlineRounded(draw, low, high, colour::kPanelEdge, 0);
}

MenuRequest homePage(Context& context, Home& home, Activities& activities, const std::string& driver,
                     PanelState& panels) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    drawBackdrop(screen.x, screen.y);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(screen);
    const bool low = lowerThan(context, kLowWindow); // the list needs the height
    const float edge = context.points(narrowerThan(context, 480) ? 12.0f : 24.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {edge, context.points(low ? 8.0f : 16.0f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::Begin("home", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar(2);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float sign = context.points(low ? 26.0f : 52.0f);
    drawSign(*ImGui::GetWindowDrawList(), {at.x + sign / 2, at.y + sign / 2}, sign);
    ImGui::Dummy({sign, sign});
    ImGui::SameLine(0, context.points(14));
    ImGui::BeginGroup();
    ImGui::PushFont(low ? context.fonts.strong : context.fonts.title);
    const HomeWords words = wordsOf(context, home, activities);
    ImGui::TextUnformatted(phrase(words.heading).c_str());
    ImGui::PopFont();
    if (!low) quietText(context, phrase(words.hint));
    ImGui::EndGroup();
    if (!home.who.asked()) personsButton(context, home.who, true);
    beginPart("lessons", {0, -context.points(44)});
    MenuRequest request = MenuRequest::none;
    if (home.who.asked())
        request = personsPart(context, home.who, true);
    else if (home.attempts.shown())
        request = attemptTable(context, home, activities);
    else if (lessonGrid(context, home))
        request = MenuRequest::openLesson;
    ImGui::EndChild();
    markItem(context, "home.lessons");
    if (button(context, "home.help", phrase("home.help").c_str(), panels.help ? ButtonKind::lit : ButtonKind::plain, 86,
               phrase("home.help_tip").c_str()))
        panels.help = !panels.help;
    ImGui::SameLine(0, context.points(14));
    if (button(context, "home.settings", phrase("home.settings").c_str(),
               panels.settings ? ButtonKind::lit : ButtonKind::plain, 100, phrase("home.settings_tip").c_str()))
        panels.settings = !panels.settings;
    if (!home.who.asked()) {
        ImGui::SameLine(0, context.points(14));
        attemptsButton(context, home, activities);
    }
    ImGui::SameLine(0, context.points(14));
    ImGui::AlignTextToFramePadding();
    quietLine(context, driver);
    ImGui::End();
    return request;
}

MenuRequest homePart(Context& context, Home& home, Activities& activities) {
    MenuRequest request = MenuRequest::none;
    if (home.who.asked()) return personsPart(context, home.who, false);
    if (home.attempts.shown()) {
        request = attemptList(context, home, activities, kAttemptsOnPanel);
        attemptsButton(context, home, activities);
        return request;
    }
    const std::vector<HomePage> pages = pagesOf(home);
    home.page = std::min(home.page, pages.size() - 1);
    const HomePage& page = pages[home.page];
    const ImVec2 size{ImGui::GetContentRegionAvail().x, context.points(kRowHeight)};
    for (size_t i = page.begin; i < page.end; ++i)
        if (lessonTile(context, home, i, size, true, false)) request = MenuRequest::openLesson;
    attemptsButton(context, home, activities);
    if (pages.size() == 1) return request;
    ImGui::SameLine();
    if (button(context, "home.previous", phrase("home.previous").c_str(), ButtonKind::plain, 100) && home.page > 0)
        --home.page;
    ImGui::SameLine();
    if (button(context, "home.following", phrase("home.following").c_str(), ButtonKind::plain, 100) &&
        home.page + 1 < pages.size())
        ++home.page;
    ImGui::SameLine();
    quietText(context, phrase(home.groups().size() > 1 ? "home.page_of_group" : "home.page",
                              {{"page", std::to_string(home.page + 1)},
                               {"pages", std::to_string(pages.size())},
                               {"group", headingOf(page.origin)}}));
    return request;
}

} // namespace meltpool::ui
