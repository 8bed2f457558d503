// The interface's own controls, made from parameter descriptions: sliders, switches, choices, buttons.
#pragma once

#include "app/desktop/ui/theme.hpp"
#include "core/base/parameter.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool::ui {

/// A place on the screen in points, for tests and for help that points at things.
struct Place {
    float x = 0;
    float y = 0;
    float width = 0;
    float height = 0;
};

/// What every panel needs while it is drawn.
struct Context {
    Fonts fonts;
    float scale = 1;
    float startValuesHeight = 0; ///< what the start menu's values took in the last frame; 0: not drawn yet
    /// Where each control was drawn this frame, by name such as "simulation.viscosity"; only those in sight.
    std::map<std::string, Place> places;

    float points(float size) const { return size * scale; }
};

/// Notes the last item's place under `name` when it is in sight.
void markItem(Context& context, const std::string& name);

/// A parameter's values before anyone touched them, by key, so that a control can offer the way back.
using DefaultTexts = std::map<std::string, std::string, std::less<>>;
DefaultTexts defaultTexts(const ParameterList& list);

/// Draws one parameter with label, value, unit and tooltip; true when it was changed. `prefix` starts its name among
/// the places.
bool parameterControl(Context& context, const std::string& prefix, const Parameter& parameter,
                      const DefaultTexts& defaults);

/// A heading of a group; false when it is folded.
bool groupHeading(Context& context, const std::string& prefix, const char* title, bool openAtFirst = true);

enum class ButtonKind { plain, main, lit };
/// A button of the given width in points (0: as wide as its text).
bool button(Context& context, const std::string& name, const char* text, ButtonKind kind = ButtonKind::plain,
            float width = 0, const char* tooltip = nullptr);

/// A switch with its label.
bool toggle(Context& context, const std::string& name, const char* label, bool& value, const char* tooltip = nullptr);

/// Buttons of which one is chosen, wrapped into rows.
bool choiceRow(Context& context, const std::string& name, std::span<const std::string_view> choices, int& value);

void quietText(Context& context, const std::string& text);
void strongText(Context& context, const std::string& text);
/// The tooltip of the last item, wrapped to a readable width.
void tooltip(Context& context, const std::string& text);

/// A number for people: at most four digits, no needless zeros.
std::string niceNumber(double value);
/// "what it costs" -> "What it costs."
std::string sentence(std::string_view text);
/// "rest_density" -> "Rest density".
std::string readableName(std::string_view key);

} // namespace meltpool::ui
