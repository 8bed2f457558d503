// Declares the screens and panels of the window. Each function draws one and returns the person's request.
#pragma once

#include "app/activities/question.hpp"
#include "app/session/controls.hpp"
#include "app/session/home.hpp"
#include "app/session/lesson_figures.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/menu_state.hpp"
#include "app/session/messages.hpp"
#include "app/session/parameter_section.hpp"
#include "app/ui/key_guide.hpp"
#include "app/ui/widgets.hpp"
#include "core/gl/profiler.hpp"
#include "core/render/scene.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace meltpool::ui {

/// Name of the top bar's window.
inline constexpr const char* kTopBar = "top bar";

/// Width of the panels at the sides, with their gap to the picture; points.
float panelReach(const Context& context);
/// Height of the bars at the top and bottom, points.
float barHeight(const Context& context);

/// Highest temperature: "1530 °C"; for the classic metal, whose scale has no unit, "0.53".
ShortText hottestText(const LessonFigures& figures);

/// Draws the list of lessons in the whole window, with the buttons of help and settings.
MenuRequest homePage(Context& context, Home& home, Activities& activities, const std::string& driver,
                     PanelState& panels);
/// Draws the settings that belong to no lesson over everything, for the list of lessons. `sections`: those of the view
/// menu. A click beside the page closes it.
void settingsOverlay(Context& context, bool& open, std::span<const ParameterSection* const> sections);
/// Draws the list of lessons inside the current window, a few a page, for the headset's panel.
MenuRequest homePart(Context& context, Home& home, Activities& activities);
/// Draws the question for the name of the person who welds inside the current window. `typing`: with a field for it.
MenuRequest personsPart(Context& context, WhoWelds& who, bool typing);
/// Draws the button with the name of the person who welds, which asks for the next one. `atRight`: at the right end of
/// the last item's line, or below it if there is no room.
void personsButton(Context& context, WhoWelds& who, bool atRight);
/// Draws the lesson's first page: task, machine values, start.
MenuRequest startMenu(Context& context, LessonSession& session, Home& home, const std::string& driver);
/// Draws the values that are set before the start, inside the current window.
void setupPart(Context& context, LessonSession& session);
MenuRequest topBar(Context& context, PanelState& panels, const Controls& controls, const LessonSession& session);
/// Draws the keys for what the person does now, as many as fit, and the figures.
void statusBar(Context& context, const LessonFigures& figures, const KeySituation& now);
/// Draws the caption of sounds above the status bar in the middle of the uncovered width; `left`, `right`: width
/// covered by panels, points.
void captionLine(Context& context, std::string_view caption, float left, float right);
/// Draws the names of cues at their fields of the board, on the picture.
void cueNames(Context& context, std::span<const NamedCue> cues);
void viewMenu(Context& context, std::span<const ParameterSection* const> sections);
/// Draws the machine's values and the makers' charts for them; closed below them, in the expert drawer, the solver's.
void machinePart(Context& context, LessonSections& sections);
void machineMenu(Context& context, LessonSections& sections, Controls& controls);
/// Draws the shown row of the charts, with its source, inside the current window; no-op for a process without an arc.
/// Allocates nothing while plates, machine and row stay.
void chartPart(Context& context, ChartValues& chart);
/// Draws the running demonstration above the status bar, in the middle of the uncovered width: pause, its time, and the
/// button for one's own attempt. `left`, `right`: width covered by panels, points; with too little room left it
/// overlaps them.
MenuRequest demonstrationBar(Context& context, LessonSession& session, float left, float right);
/// Draws the running demonstration inside the current window, for the headset's panel.
MenuRequest demonstrationPart(Context& context, LessonSession& session);
/// Draws a saved attempt above the status bar: pause, its time, speed, curves and events, and the comparison of its end
/// with the recording.
MenuRequest replayBar(Context& context, LessonSession& session);
/// Draws a saved attempt inside the current window, for the headset's panel.
MenuRequest replayPart(Context& context, LessonSession& session);
/// Draws the saved attempts as a table, inside the current window: filter, headings that sort, as many rows as fit, and
/// the buttons of the chosen one. The comparison of two replaces it during that activity.
MenuRequest attemptTable(Context& context, Home& home, Activities& activities);
/// Draws the saved attempts, newest first, `rows` a page, for the headset's panel; the comparison of two of them
/// replaces the list during that activity.
MenuRequest attemptList(Context& context, Home& home, Activities& activities, size_t rows);
/// Draws two attempts next to each other: the remaining welds, then difference, figures and curves of both, inside the
/// current window.
void comparisonPart(Context& context, Activities& activities);
/// Width of the result panel with its gap to the picture; points.
float resultReach(const Context& context);
/// Draws the judged attempt at the left: score, corrections, verdict, measured weld. `fromTop`: scrolls to its top.
MenuRequest resultPanel(Context& context, LessonSession& session, const Home& home, bool fromTop);
/// Draws a likely cause and remedy for each imperfection that fails, inside the current window. `tries`: with a button
/// for each that a what-if can try. Returns the pressed one. Allocates nothing.
std::optional<size_t> curesPart(Context& context, std::span<const CureRow> cures, bool tries);
/// Draws score and verdict of the judged attempt inside the current window.
void resultHead(Context& context, LessonSession& session, const Home& home);
/// Name of the result's bright button: the next lesson after an accepted weld.
std::string_view brightResultButton(bool judged, bool accepted, bool hasNext);
/// Surroundings of the result: the panel draws resultHead() and the way home itself.
enum class ResultPlace { window, panel };
/// Draws the buttons of the judged attempt and all of its values inside the current window.
MenuRequest resultPart(Context& context, LessonSession& session, const Home& home, ResultPlace place);
/// Draws the button that cuts the weld open, inside the current window, and, while it is open, the place of the cut.
MenuRequest cutPart(Context& context, LessonSession& session);
/// Draws the hand of the judged attempt along the seam, with the lesson's bands (null: none), inside the current
/// window, folded at first. Allocates nothing.
void curvesPart(Context& context, const Judgement& judgement, const TechniqueBands* bands);
/// Draws the bend test of the judged weld, or the break of a fillet, strap by strap, inside the current window.
void bendPart(Context& context, const BendTest& test);
void timingsPanel(Context& context, const gl::Profiler& profiler, const LessonFigures& figures, double frameMs,
                  const std::string& driver, bool besideView);
/// Draws a question over all other panels, a button for each answer. No-op without a question.
void questionOverlay(Context& context, Question& question);
/// Draws a question inside the current window, for the headset's panel.
void questionPart(Context& context, Question& question);
/// Draws the help page: all keys for what the person does now.
void helpOverlay(Context& context, bool& open, const KeySituation& now);
/// Draws the messages at the top. `left`, `right`: width covered by panels there, points. A click hides a message.
/// `welds`: the person welds; in a low window the messages, which would cover the arc, wait meanwhile.
void messageStack(Context& context, Messages& messages, float left, float right, bool welds);
/// To be called before Dear ImGui's frame: the wheel then moves what is below the messages, which do not scroll.
/// `wheelMoves`: in this frame.
void letWheelThroughMessages(bool wheelMoves);
/// Draws the colour scale of the temperature displays; `colours` is LookParameters::colours. `left`: width covered by
/// panels at the left, points.
void temperatureScale(Context& context, int colours, const TemperatureMeaning& meaning, float left);

/// Draws a picture with a thin edge, from corner to corner.
void drawPicture(ImDrawList& draw, GLuint texture, ImVec2 low, ImVec2 high);
/// Draws the program's logo, a metal cube with a molten corner. `size` in points.
void drawSign(ImDrawList& draw, ImVec2 centre, float size);
/// Draws the dark workshop glow behind the start menu.
void drawBackdrop(float width, float height);

} // namespace meltpool::ui
