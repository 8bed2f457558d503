// The screens and panels of the window. Each function draws one and answers what the person asked for.
#pragma once

#include "app/activities/question.hpp"
#include "app/session/controls.hpp"
#include "app/session/home.hpp"
#include "app/session/lesson_figures.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/menu_state.hpp"
#include "app/session/messages.hpp"
#include "app/session/parameter_section.hpp"
#include "app/ui/widgets.hpp"
#include "core/gl/profiler.hpp"
#include "core/render/scene.hpp"

#include <optional>
#include <span>
#include <string>

namespace meltpool::ui {

/// Width of the panels at the sides, with their gap to the picture; points.
float panelReach(const Context& context);
/// Height of the bars at the top and bottom, points.
float barHeight(const Context& context);

/// The highest temperature: "1530 °C"; of the classic metal, whose scale has no unit, "0.53".
ShortText hottestText(const LessonFigures& figures);

/// The list of lessons in the whole window. `help`: its button was pressed.
MenuRequest homePage(Context& context, Home& home, Activities& activities, const std::string& driver, bool& help);
/// The same inside the current window, a few lessons a page, for the headset's panel.
MenuRequest homePart(Context& context, Home& home, Activities& activities);
/// The lesson's first page: what is asked for, the machine's values, start.
MenuRequest startMenu(Context& context, LessonSession& session, Home& home, const std::string& driver);
/// The values that are chosen before the start, inside the current window.
void setupPart(Context& context, LessonSession& session);
MenuRequest topBar(Context& context, PanelState& panels, const Controls& controls, const LessonSession& session);
void statusBar(Context& context, const LessonFigures& figures, const Controls& controls);
/// What is heard, above the status bar in the middle of what panels leave free; `left`, `right`: what they cover,
/// points.
void captionLine(Context& context, std::string_view caption, float left, float right);
void viewMenu(Context& context, std::span<const ParameterSection* const> sections);
/// The machine's values; closed below them, in the expert drawer, the solver's.
void machinePart(Context& context, const ParameterSection& section);
void machineMenu(Context& context, const ParameterSection& section, Controls& controls);
/// The running demonstration above the status bar, in the middle of what panels leave free: pause, its time, and the
/// way to one's own attempt. `left`, `right`: what panels cover, points; where they leave too little room, it lies over
/// them.
MenuRequest demonstrationBar(Context& context, LessonSession& session, float left, float right);
/// The same inside the current window, for the headset's panel.
MenuRequest demonstrationPart(Context& context, LessonSession& session);
/// A kept attempt above the status bar: pause, its time, speed, curves and events, and what its end was compared with.
MenuRequest replayBar(Context& context, LessonSession& session);
/// The same inside the current window, for the headset's panel.
MenuRequest replayPart(Context& context, LessonSession& session);
/// The attempts that were kept, newest first, `rows` a page, inside the current window; in their place the comparison
/// of two of them while the person is at it.
MenuRequest attemptList(Context& context, Home& home, Activities& activities, size_t rows);
/// Two attempts beside each other: what is still to be welded, then difference, figures and curves of both, inside the
/// current window.
void comparisonPart(Context& context, Activities& activities);
/// Width of the result panel with its gap to the picture; points.
float resultReach(const Context& context);
/// The judged attempt at the left: score, what to correct, verdict, measured weld.
MenuRequest resultPanel(Context& context, LessonSession& session, const Home& home);
/// The same inside the current window, for the headset's panel.
MenuRequest resultPart(Context& context, LessonSession& session, const Home& home);
/// The button that cuts the weld open, inside the current window, and, while it is open, the place of the cut.
MenuRequest cutPart(Context& context, LessonSession& session);
/// The hand of the judged attempt along the seam, with the lesson's bands (null: it has none), inside the current
/// window, folded at first. Allocates nothing.
void curvesPart(Context& context, const Judgement& judgement, const TechniqueBands* bands);
/// The bend test of the judged weld, or the break of a fillet, strap by strap, inside the current window.
void bendPart(Context& context, const BendTest& test);
void timingsPanel(Context& context, const gl::Profiler& profiler, const LessonFigures& figures, double frameMs,
                  const std::string& driver, bool besideView);
/// A question over all other panels, a button for each answer. Nothing where none is asked.
void questionOverlay(Context& context, Question& question);
/// The same inside the current window, for the headset's panel.
void questionPart(Context& context, Question& question);
void helpOverlay(Context& context, bool& open);
/// Messages at the top. `left`, `right`: what panels cover there, points. A click hides a message.
void messageStack(Context& context, Messages& messages, float left, float right);
/// The colour scale of the temperature displays; `colours` is LookParameters::colours.
/// `left`: what panels cover at the left, points.
void temperatureScale(Context& context, int colours, const TemperatureMeaning& meaning, float left);

/// A picture with a thin edge, from corner to corner.
void drawPicture(ImDrawList& draw, GLuint texture, ImVec2 low, ImVec2 high);
/// The program's logo, a metal cube with a molten corner. `size` in points.
void drawSign(ImDrawList& draw, ImVec2 centre, float size);
/// The dark workshop glow behind the start menu.
void drawBackdrop(float width, float height);

} // namespace meltpool::ui
