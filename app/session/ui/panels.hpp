// The screens and panels of the desktop trainer. Each draws itself and says what the person asked for.
#pragma once

#include "app/session/controls.hpp"
#include "app/session/messages.hpp"
#include "app/session/ui/widgets.hpp"
#include "core/gl/profiler.hpp"
#include "core/render/scene.hpp"

#include <optional>
#include <span>
#include <string>

namespace meltpool::ui {

/// Parameters that belong together, with the values they had before anyone touched them.
struct Section {
    std::string name; ///< starts the names of its controls, and is its table in the settings file
    ParameterList parameters;
    DefaultTexts defaults;
};

/// Which panels are open.
struct PanelState {
    bool view = false;
    bool simulation = true;
    bool timings = false;
    bool help = false;
    bool hidden = false; ///< everything out of the way of the picture
};
ParameterList describe(PanelState& panels);

enum class Request { none, start, startWithDefaults, reset, restart };

/// What the bars tell about the metal.
struct Figures {
    double time = 0;  ///< simulated seconds
    double speed = 1; ///< simulated over real time
    double framesPerSecond = 0;
    size_t particles = 0;
    size_t molten = 0;
    double hottest = 0;   ///< 0..1, or K
    bool kelvin = false;  ///< which of the two
    size_t lost = 0;      ///< particles that left the box or became no number
    size_t refused = 0;   ///< new particle states that were no number and were refused, since the reset
    bool stopped = false; ///< the state is no longer finite and the simulation stands still
};

/// Width of the panels at the sides, with their gap to the picture; points.
float panelReach(const Context& context);
/// Height of the bars at the top and bottom, points.
float barHeight(const Context& context);

Request startMenu(Context& context, const Section& start, const std::string& task, const std::string& driver);
Request topBar(Context& context, PanelState& panels, const Controls& controls, const std::string& lesson);
void statusBar(Context& context, const Figures& figures, const Controls& controls);
void viewMenu(Context& context, std::span<const Section* const> sections);
void simulationMenu(Context& context, const Section& section, Controls& controls);
void timingsPanel(Context& context, const gl::Profiler& profiler, const Figures& figures, double frameMs,
                  const std::string& driver, bool besideView);
void helpOverlay(Context& context, bool& open);
/// Messages at the top, between what panels cover at the left and right (points); a click takes one away.
void messageStack(Context& context, Messages& messages, float left, float right);
/// The colour scale of the temperature displays; `colours` is LookParameters::colours.
/// `left`: what panels cover at the left, points.
void temperatureScale(Context& context, int colours, const TemperatureMeaning& meaning, float left);

/// The metal cube with its molten corner, the program's sign. `size` in points.
void drawSign(ImDrawList& draw, ImVec2 centre, float size);
/// The dark workshop glow behind the start menu.
void drawBackdrop(float width, float height);

} // namespace meltpool::ui
