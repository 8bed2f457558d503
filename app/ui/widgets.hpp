// Draws the controls of the menus, made from parameter descriptions: sliders, switches, choices, buttons.
#pragma once

#include "app/session/key_names.hpp"
#include "app/session/menu_state.hpp"
#include "app/session/parameter_section.hpp"
#include "app/ui/focus_ring.hpp"
#include "app/ui/theme.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_text.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool::ui {

/// Shared state of the panels while they are drawn.
struct Context {
    Fonts fonts;
    float scale = 1;
    float startValuesHeight = 0; ///< height of the start menu's scrolling part in the last frame; 0: not drawn yet
    float startFootHeight = 0;   ///< height of the buttons below it
    float attemptsNotice = 0;    ///< height of the lines below the attempts in the last frame
    float playHeight = 0;        ///< height of a replay's or demonstration's panel in the last frame; 0: not drawn yet
    /// Last place of each control, by name such as "simulation.viscosity". Entries stay from frame to frame, so that
    /// noting a place allocates nothing.
    std::map<std::string, Place, std::less<>> places;
    unsigned frame = 0;
    /// Control that the pointer is over, for tooltips.
    struct {
        unsigned frame = 0; ///< last frame of it
        ImVec2 corner{0, 0};
        double since = 0; ///< s, ImGui::GetTime()
    } pointed;
    bool tooltipsAtEdge = false;               ///< tooltips lie at the upper or lower edge, far from the pointer
    bool typing = true;                        ///< there is a keyboard to type numbers with
    const KeyNames* keys = &KeyNames::usual(); ///< names of the current keyboard's keys

    FocusRing windows;      ///< windows that keys can reach
    std::string focus;      ///< name of the control that keys have chosen; empty: none is
    std::string lastFocus;  ///< name of the control that keys have chosen last
    bool gamepad = false;   ///< one is connected
    bool byGamepad = false; ///< the gamepad was used last: hints name its buttons

    void beginFrame() {
        ++frame;
        focus.clear();
        windows.beginFrame();
    }
    bool shown(const Place& place) const { return place.frame == frame; }
    float points(float size) const { return size * scale; }
    std::string_view key(Key letter) const { return keys->of(letter); }
};

/// Notes the last item's place under `name` if it is in sight. Outlines it if keys have chosen it.
void markItem(Context& context, std::string_view name);

/// Notes the current window for the keys that go from window to window.
void noteWindow(Context& context, const char* name);
/// Begins a scrolling part of the window that keys enter and leave like the rest of it. A size of 0: as far as the
/// window goes. ImGui::EndChild() ends it.
void beginPart(const char* name, ImVec2 size);

/// Breaks a text into at most `lines` lines of whole words, `width` pixels wide; the last one ends with a mark if there
/// are more.
std::vector<std::string> wholeWords(ImFont& font, float size, std::string_view text, float width, size_t lines);

/// Draws one parameter with label, value, unit and tooltip; returns true if it was changed. `prefix` starts its name
/// among the places, and is the table of its phrases.
bool parameterControl(Context& context, std::string_view prefix, const Parameter& parameter,
                      const DefaultTexts& defaults);

/// Draws one parameter of a section; a value given by the lesson has no control.
bool parameterControl(Context& context, const ParameterSection& section, const Parameter& parameter);

/// Draws the heading of a group; returns false if it is folded. `title` names it among the places; it is shown in the
/// chosen language (group.TITLE in small letters with low lines).
bool groupHeading(Context& context, std::string_view prefix, const char* title, bool openAtFirst = true);
/// Draws a heading as groupHeading(), for a title made elsewhere: `name` names it among the places in every language.
bool namedHeading(Context& context, std::string_view prefix, const char* name, std::string_view title,
                  bool openAtFirst = true);

enum class ButtonKind { plain, main, lit };
/// Draws a button of the given width in points (0: as wide as its text); wider if its text needs that, and with several
/// lines of text if the window has less room.
bool button(Context& context, std::string_view name, const char* text, ButtonKind kind = ButtonKind::plain,
            float width = 0, const char* tooltip = nullptr);

/// Lays out buttons in a row; those that the window has no room for go below.
class ButtonRow {
  public:
    /// `gap` between two buttons, points.
    explicit ButtonRow(Context& context, float gap = 6);
    /// Adds a button as button() does.
    bool add(std::string_view name, const char* text, ButtonKind kind = ButtonKind::plain, float width = 0,
             const char* tooltip = nullptr);
    /// Reserves room for an item of this width, points: next to the last one or below it.
    void place(float width);

  private:
    Context& context_;
    float gap_;
    float right_; ///< right end of the room, pixels of the screen
    bool first_ = true;
};

/// Returns true if the window has less room in this direction than so many points.
bool narrowerThan(const Context& context, float width);
bool lowerThan(const Context& context, float height);

/// Draws a switch with its label. `hovered` may be null; with it the caller makes a long tooltip only while it is
/// shown.
bool toggle(Context& context, std::string_view name, std::string_view label, bool& value, const char* tooltip = nullptr,
            bool* hovered = nullptr);

/// Draws buttons of which one is chosen, wrapped into rows. `words` starts the keys of their phrases: "group" of
/// "group.view". `names`: their texts instead of phrases, as Parameter::choiceNames.
bool choiceRow(Context& context, std::string_view name, std::span<const std::string_view> choices, int& value,
               std::string_view words = "group", std::span<const std::string_view> names = {});

/// Draw a rectangle with rounded corners, `radius` in pixels: its inside, its edge. These two draw every rectangle of
/// the interface: Dear ImGui 1.86 divides by zero if the radius that it finds room for is between 0 and 1e-6 pixels, as
/// with a side of 2.000001 pixels. Rectangles with a side below 3.5 pixels get sharp corners.
void fillRounded(ImDrawList& draw, ImVec2 low, ImVec2 high, ImU32 tint, float radius,
                 ImDrawFlags corners = ImDrawFlags_RoundCornersAll);
void outlineRounded(ImDrawList& draw, ImVec2 low, ImVec2 high, ImU32 tint, float radius);

/// Draws a text in as many lines as it needs, `room` wide; 0: as wide as the window. It is broken between words, while
/// Dear ImGui would break a number at its dot.
void wrappedText(std::string_view text, float room = 0);
void quietText(Context& context, std::string_view text);
/// Draws one line of the text, cut off at the window's end; all of it while the mouse points at it.
void quietLine(Context& context, std::string_view text);
void strongText(Context& context, std::string_view text);
/// Shows the tooltip of the last item, wrapped to a readable width.
void tooltip(Context& context, std::string_view text);

/// Writes a number for people: at most four digits, no needless zeros.
ShortText niceNumber(double value);
/// Turns "costs time" into "Costs time."
std::string sentence(std::string_view text);
/// Turns "rest_density" into "Rest density".
ShortText readableName(std::string_view key);

} // namespace meltpool::ui
