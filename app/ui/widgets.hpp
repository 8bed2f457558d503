// The controls of the menus, made from parameter descriptions: sliders, switches, choices, buttons.
#pragma once

#include "app/session/key_names.hpp"
#include "app/session/menu_state.hpp"
#include "app/session/parameter_section.hpp"
#include "app/ui/theme.hpp"
#include "core/base/parameter.hpp"
#include "core/base/short_text.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool::ui {

/// What every panel needs while it is drawn.
struct Context {
    Fonts fonts;
    float scale = 1;
    float startValuesHeight = 0; ///< of what scrolls on the start menu, in the last frame; 0: not drawn yet
    float startFootHeight = 0;   ///< of the buttons below it
    /// Where each control was drawn last, by name such as "simulation.viscosity". Kept from frame to frame, so that
    /// noting a place allocates nothing.
    std::map<std::string, Place, std::less<>> places;
    unsigned frame = 0;
    const KeyNames* keys = &KeyNames::usual(); ///< of the keyboard that is there

    void beginFrame() { ++frame; }
    bool shown(const Place& place) const { return place.frame == frame; }
    float points(float size) const { return size * scale; }
    std::string_view key(Key letter) const { return keys->of(letter); }
};

/// Notes the last item's place under `name` when it is in sight.
void markItem(Context& context, std::string_view name);

/// Draws one parameter with label, value, unit and tooltip; true when it was changed. `prefix` starts its name among
/// the places, and is the table of its words.
bool parameterControl(Context& context, std::string_view prefix, const Parameter& parameter,
                      const DefaultTexts& defaults);

/// The same for one of a section; a value that the lesson gives is shown without a control.
bool parameterControl(Context& context, const ParameterSection& section, const Parameter& parameter);

/// A heading of a group; false when it is folded. `title` names it among the places; it is shown in the chosen language
/// (group.TITLE in small letters with low lines).
bool groupHeading(Context& context, std::string_view prefix, const char* title, bool openAtFirst = true);
/// As groupHeading(), for a title that is made elsewhere: `name` names it among the places in every language.
bool namedHeading(Context& context, std::string_view prefix, const char* name, std::string_view title,
                  bool openAtFirst = true);

enum class ButtonKind { plain, main, lit };
/// A button of the given width in points (0: as wide as its text); wider where its text needs that, and with several
/// lines of text where the window has less room.
bool button(Context& context, std::string_view name, const char* text, ButtonKind kind = ButtonKind::plain,
            float width = 0, const char* tooltip = nullptr);

/// Buttons beside each other; those that the window has no room for go below.
class ButtonRow {
  public:
    /// `gap` between two buttons, points.
    explicit ButtonRow(Context& context, float gap = 6);
    /// As button().
    bool add(std::string_view name, const char* text, ButtonKind kind = ButtonKind::plain, float width = 0,
             const char* tooltip = nullptr);
    /// Room for an item of this width, points: beside the last one or below it.
    void place(float width);

  private:
    Context& context_;
    float gap_;
    float right_; ///< where the room ends, pixels of the screen
    bool first_ = true;
};

/// Whether the window has less room in this direction than so many points.
bool narrowerThan(const Context& context, float width);
bool lowerThan(const Context& context, float height);

/// A switch with its label.
/// `hovered` may be null; with it the caller makes a long tooltip only while it is shown.
bool toggle(Context& context, std::string_view name, std::string_view label, bool& value, const char* tooltip = nullptr,
            bool* hovered = nullptr);

/// Buttons of which one is chosen, wrapped into rows. `words` starts the keys of their words: "group" of "group.view".
bool choiceRow(Context& context, std::string_view name, std::span<const std::string_view> choices, int& value,
               std::string_view words = "group");

/// Draw a rectangle with rounded corners, `radius` in pixels: its inside, its edge. Every rectangle of the interface is
/// drawn by these two: Dear ImGui 1.86 divides by zero when the radius that it finds room for is between 0 and 1e-6
/// pixels, as with a side of 2.000001 pixels. Rectangles with a side below 3.5 pixels get sharp corners.
void fillRounded(ImDrawList& draw, ImVec2 low, ImVec2 high, ImU32 tint, float radius,
                 ImDrawFlags corners = ImDrawFlags_RoundCornersAll);
void outlineRounded(ImDrawList& draw, ImVec2 low, ImVec2 high, ImU32 tint, float radius);

void quietText(Context& context, std::string_view text);
/// One line of it, cut where the window ends; all of it while the mouse points at it.
void quietLine(Context& context, std::string_view text);
void strongText(Context& context, std::string_view text);
/// The tooltip of the last item, wrapped to a readable width.
void tooltip(Context& context, std::string_view text);

/// A number for people: at most four digits, no needless zeros.
ShortText niceNumber(double value);
/// "what it costs" -> "What it costs."
std::string sentence(std::string_view text);
/// "rest_density" -> "Rest density".
ShortText readableName(std::string_view key);

} // namespace meltpool::ui
