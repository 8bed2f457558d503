// Draws view menu, machine menu, timings and help of the running trainer.
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>

namespace meltpool::ui {

namespace {

constexpr float kPanelWidth = 336;
constexpr float kPanelGap = 10;

enum class Side { left, leftBeside, right };

/// Begins a panel along one side of the picture, as tall as its content, at most down to the status bar.
void beginPanel(Context& context, const char* name, Side side) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float gap = context.points(kPanelGap);
    const float width = std::min(context.points(kPanelWidth), screen.x - 2 * gap);
    const float room = screen.y - 2 * barHeight(context) - 2 * gap;
    const float x = side == Side::right ? screen.x - width - gap : gap + (side == Side::leftBeside ? width + gap : 0);
    ImGui::SetNextWindowPos({x, barHeight(context) + gap});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, room});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    noteWindow(context, name);
}

void panelTitle(Context& context, const char* title, const char* what) {
    strongText(context, title);
    quietText(context, what);
}

/// Group of parameters under one heading of a menu.
struct Group {
    const char* section;
    const char* title;
    std::array<std::string_view, 6> keys; ///< unused ones are empty
    bool openAtFirst;
};

const ParameterSection* findSection(std::span<const ParameterSection* const> sections, std::string_view name) {
    for (const ParameterSection* section : sections)
        if (section->name == name) return section;
    return nullptr;
}

/// Returns true if the parameter belongs to the group. Parameters of the start alone belong to none.
bool stands(const Parameter& parameter, const Group& group) {
    return !parameter.onlyAtStart && std::find(group.keys.begin(), group.keys.end(), parameter.key) != group.keys.end();
}

/// Draws a heading and the parameters for which `belongs` is true; no-op if there are none.
template <class Belongs>
void drawGroup(Context& context, const ParameterSection& section, const char* title, bool openAtFirst,
               const Belongs& belongs) {
    const auto drawn = [&](const Parameter& p) { return section.shows(p) && belongs(p); };
    if (std::none_of(section.parameters.begin(), section.parameters.end(), drawn)) return;
    if (!groupHeading(context, section.name, title, openAtFirst)) return;
    for (const Parameter& parameter : section.parameters)
        if (drawn(parameter)) parameterControl(context, section, parameter);
}

/// Draws a group's parameters in the group's order.
void drawGroup(Context& context, const ParameterSection& section, const Group& group) {
    const auto belongs = [&](const Parameter& p) { return section.shows(p) && stands(p, group); };
    if (std::none_of(section.parameters.begin(), section.parameters.end(), belongs)) return;
    if (!groupHeading(context, section.name, group.title, group.openAtFirst)) return;
    for (const std::string_view key : group.keys)
        if (const Parameter* p = findParameter(section.parameters, key); p != nullptr && belongs(*p))
            parameterControl(context, section, *p);
}

/// Draws the groups in order, then all other parameters under "More".
void drawGroups(Context& context, std::span<const ParameterSection* const> sections, std::span<const Group> groups) {
    // A value in two menus has one key for both.
    const auto named = [&](const Parameter& p) {
        return std::any_of(groups.begin(), groups.end(), [&](const Group& group) {
            return stands(p, group) && findSection(sections, group.section) != nullptr;
        });
    };
    for (const Group& group : groups)
        if (const ParameterSection* section = findSection(sections, group.section)) drawGroup(context, *section, group);
    for (const ParameterSection* section : sections)
        drawGroup(context, *section, ShortText{"More: ", section->name}.c_str(), false,
                  [&](const Parameter& p) { return !p.onlyAtStart && !named(p); });
}

void passRow(Context& context, std::string_view name, double ms, double whole, int depth) {
    const ShortText text{PhraseNumber(ms, 2), " ms"};
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetTextLineHeight();
    const float share = whole > 0 ? static_cast<float>(std::min(ms / whole, 1.0)) : 0.0f;
    fillRounded(*ImGui::GetWindowDrawList(), {at.x, at.y}, {at.x + width * share, at.y + height},
                depth == 0 ? IM_COL32(255, 138, 61, 60) : IM_COL32(255, 255, 255, 20), context.points(3));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + context.points(6 + 12 * static_cast<float>(depth)));
    ImGui::PushStyleColor(ImGuiCol_Text, depth == 0 ? colour::kText : colour::kQuiet);
    ImGui::TextUnformatted(readableName(name).c_str());
    ImGui::SameLine();
    ImGui::SetCursorPosX(right - ImGui::CalcTextSize(text.c_str()).x - context.points(4));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

constexpr ImGuiWindowFlags kStill = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings;

/// Begins a page in the middle of a shade over everything; a click on the shade closes it. `width` and the margins of
/// its content in points.
void beginOverlay(Context& context, const char* name, bool& open, float width, float margin) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(screen);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(8, 10, 14, 170));
    ImGui::Begin(ShortText{name, " shade"}.c_str(), nullptr, kStill);
    if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) open = false;
    ImGui::End();
    ImGui::PopStyleColor();

    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    const float wide = std::min(context.points(width), screen.x - context.points(20));
    ImGui::SetNextWindowSizeConstraints({wide, 0}, {wide, screen.y - context.points(20)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.points(margin), context.points(26)});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(26, 30, 37, 255));
    ImGui::Begin(name, nullptr, kStill | ImGuiWindowFlags_AlwaysAutoResize);
    if (ImGui::IsWindowAppearing()) {
        ImGui::SetWindowFocus();
        ImGui::SetScrollY(0);
    }
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

/// Draws the rows of one heading; nothing if there are none.
void keyColumn(Context& context, const KeyGuide& guide, KeyHeading heading) {
    static constexpr std::array<std::string_view, size_t(KeyHeading::count)> kTitles{
        "help.heading.torch",  "help.heading.playing",     "help.heading.weld",
        "help.heading.camera", "help.heading.camera_free", "help.heading.program"};
    const auto here = [&](const KeyRow& row) { return row.heading == heading && !keyRowName(context, row).empty(); };
    if (std::none_of(guide.rows().begin(), guide.rows().end(), here)) return;
    strongText(context, phrase(kTitles[size_t(heading)]));
    const float left = ImGui::GetCursorPosX();
    ImGui::PushTextWrapPos(0);
    for (const KeyRow& row : guide.rows()) {
        if (!here(row)) continue;
        ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 178, 122, 255));
        ImGui::TextUnformatted(keyRowName(context, row).c_str());
        ImGui::PopStyleColor();
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + context.points(170));
        ImGui::TextUnformatted(phrase(row.what).c_str());
    }
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, context.points(6)});
}

} // namespace

float panelReach(const Context& context) {
    return context.points(kPanelWidth + kPanelGap);
}

void viewMenu(Context& context, std::span<const ParameterSection* const> sections) {
    beginPanel(context, "view menu", Side::left);
    panelTitle(context, phrase("menu.view").c_str(), phrase("menu.view_text").c_str());
    static constexpr std::array<Group, 11> kGroups{
        {{"cues", "Cues at the torch", {"speed", "angles", "distance", "aim", "seam", "arc"}, true},
         {"ghost", "Ghost torch", {"ghost", "ghost_pace", "ghost_file"}, false},
         {"view", "Show the metal as", {"mode", "colours", "material", "point_size"}, true},
         {"view", "In the picture", {"show_box", "show_sky", "show_source"}, true},
         {"view", "Light", {"ambient", "diffuse", "specular", "shininess", "exposure", "light_position"}, false},
         {"controls",
          "Torch at the desk",
          {"torch_mouse_mm", "key_speed_mm_s", "space_latch", "gamepad_speed_mm_s", "guide_speed_mm_s", "hand_tremor"},
          false},
         {"sound", "Sound", {"volume", "captions"}, false},
         {"surface", "Expert: surface", {"influence", "iso_level", "caps"}, false},
         {"controls",
          "Mouse and keys",
          {"source_step", "source_mouse_speed", "look_speed", "camera_speed", "invert_look"},
          false},
         {"window", "Window", {"interface_size", "language", "units", "picture", "detail"}, false},
         {"recordings", "Recordings", {"keep_recordings", "recordings_limit_mb"}, false}}};
    drawGroups(context, sections, kGroups);
    ImGui::End();
}

void machinePart(Context& context, LessonSections& sections) {
    const ParameterSection& section = sections.simulation;
    drawGroup(context, section, "Settings in use", true,
              [&](const Parameter& p) { return !p.onlyAtStart && !section.isExpert(p); });
    chartPart(context, sections.chart);
    const auto expert = [&](const Parameter& p) { return !p.onlyAtStart && section.shows(p) && section.isExpert(p); };
    if (std::none_of(section.parameters.begin(), section.parameters.end(), expert)) return;
    if (!groupHeading(context, section.name, "Expert", false)) return;
    static constexpr std::array<Group, 2> kGroups{
        {{"simulation",
          "Liquid metal",
          {"viscosity", "gas_stiffness", "rest_density", "particle_mass", "support_radius", "solidify_rate"},
          true},
         {"simulation",
          "Space and time",
          {"gravity", "wall_restitution", "wall_slip", "acceleration_limit", "time_step"},
          true}}};
    for (const Group& group : kGroups)
        drawGroup(context, section, group);
    drawGroup(context, section, "More", false, [&](const Parameter& p) {
        return expert(p) &&
               std::none_of(kGroups.begin(), kGroups.end(), [&p](const Group& group) { return stands(p, group); });
    });
}

void machineMenu(Context& context, LessonSections& sections, Controls& controls) {
    beginPanel(context, "machine menu", Side::right);
    panelTitle(context, phrase("menu.machine").c_str(), phrase("menu.machine_text").c_str());
    bool cold = controls.source().cold();
    // Only the source of the classic lesson cools.
    if (findParameter(sections.simulation.parameters, "heat_temperature") != nullptr) {
        ShortText note;
        appendPhrase(note, "menu.cold_tip", {{"key", context.key(Key::f)}});
        if (toggle(context, "simulation.cold", phrase("menu.cold"), cold, note.c_str()))
            controls.source().setCold(cold);
    }
    machinePart(context, sections);
    ImGui::End();
}

void timingsPanel(Context& context, const gl::Profiler& profiler, const LessonFigures& figures, double frameMs,
                  const std::string& driver, bool besideView) {
    beginPanel(context, "timings", besideView ? Side::leftBeside : Side::left);
    panelTitle(context, phrase("menu.timings").c_str(), driver.c_str());
    ShortText text;
    appendPhrase(text, "menu.frames_per_second", {{"frames", PhraseNumber(figures.framesPerSecond)}});
    ImGui::TextUnformatted(text.c_str());
    ImGui::PushFont(context.fonts.small);
    passRow(context, phrase("menu.whole_frame"), frameMs, frameMs, 0);
    for (const gl::PassTime& pass : profiler.passes())
        passRow(context, pass.name, pass.lastMs, frameMs, pass.depth);
    ImGui::PopFont();
    ImGui::End();
}

void settingsOverlay(Context& context, bool& open, std::span<const ParameterSection* const> sections) {
    static constexpr std::array<Group, 5> kGroups{
        {{"window", "Window", {"interface_size", "language", "units", "picture", "detail"}, true},
         {"sound", "Sound", {"volume", "captions"}, true},
         {"controls",
          "Torch at the desk",
          {"torch_mouse_mm", "key_speed_mm_s", "space_latch", "gamepad_speed_mm_s", "guide_speed_mm_s", "hand_tremor"},
          true},
         {"controls",
          "Mouse and keys",
          {"source_step", "source_mouse_speed", "look_speed", "camera_speed", "invert_look"},
          false},
         {"recordings", "Recordings", {"keep_recordings", "recordings_limit_mb"}, true}}};
    beginOverlay(context, "settings", open, 520, narrowerThan(context, 560) ? 18 : 32);
    const float close = context.points(110);
    const ImVec2 start = ImGui::GetCursorPos();
    ImGui::SetCursorPosX(start.x + ImGui::GetContentRegionAvail().x - close);
    if (button(context, "settings.close", phrase("help.close").c_str(), ButtonKind::main, 110)) open = false;
    const float below = ImGui::GetCursorPosY();
    ImGui::SetCursorPos(start);
    strongText(context, phrase("home.settings"));
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), below));
    quietText(context, phrase("home.settings_text"));
    ImGui::Dummy({0, context.points(4)});
    for (const Group& group : kGroups)
        if (const ParameterSection* section = findSection(sections, group.section)) drawGroup(context, *section, group);
    ImGui::End();
}

void helpOverlay(Context& context, bool& open, const KeySituation& now) {
    const bool narrow = narrowerThan(context, 760);
    beginOverlay(context, "help", open, 860, narrow ? 18 : 32);
    ImGui::Columns(narrow ? 1 : 2, "help columns", false);
    const KeyGuide guide(now);
    for (const KeyHeading heading : {KeyHeading::torch, KeyHeading::playing, KeyHeading::weld})
        keyColumn(context, guide, heading);
    if (!narrow && now.lesson) ImGui::NextColumn();
    for (const KeyHeading heading : {KeyHeading::camera, KeyHeading::looking, KeyHeading::program})
        keyColumn(context, guide, heading);
    ImGui::Columns(1);
    quietText(context, phrase(now.lesson ? "help.more" : "help.more_before"));
    if (context.gamepad) quietText(context, phrase(context.byGamepad ? "help.more_pad" : "help.more_with_pad"));
    ImGui::Dummy({0, context.points(4)});
    if (button(context, "help.close", phrase("help.close").c_str(), ButtonKind::main, 140)) open = false;
    ImGui::End();
}

} // namespace meltpool::ui
