// The one list of keys, mouse and wheel for what the person does now: the status bar and the help page are made from
// it.
#pragma once

#include "app/session/controls.hpp"
#include "app/session/gamepad_keys.hpp"
#include "app/session/input.hpp"
#include "app/session/lesson_session.hpp"
#include "app/ui/widgets.hpp"

#include <array>
#include <span>
#include <string_view>

namespace meltpool::ui {

/// The person's present activity, as far as keys depend on it.
struct KeySituation {
    bool home = false;    ///< the list of lessons
    bool lesson = false;  ///< a lesson runs; if neither: a lesson's first page
    bool looking = false; ///< the person looks around, the lesson is paused
    bool caught = false;  ///< the mouse is locked
    bool demonstration = false;
    bool replay = false;
    bool cut = false;     ///< the weld is cut open
    bool seam = false;    ///< the person's own torch is led along a seam
    bool source = false;  ///< the person's own heat source moves freely
    bool cold = false;    ///< the source can cool
    bool arc = false;     ///< the torch welds; if not, it heats
    bool rod = false;     ///< the other hand holds a filler rod
    bool weaves = false;  ///< the desk can swing the torch
    bool swings = false;  ///< and does
    bool judges = false;  ///< the weld can be judged
    bool next = false;    ///< a judged lesson is followed by another
    bool redoes = false;  ///< the attempt can go back
    bool fadedCues = false;      ///< cues are hidden, as the person has mastered them
    bool showsFadedCues = false; ///< the person shows them nevertheless
    bool headset = false; ///< a headset is in use
    bool latch = false;   ///< the space bar starts and stops the weld
    bool menus = false;   ///< keys choose controls in the running lesson's menus
};
KeySituation keySituation(const Controls& controls, LessonSession& session, bool home, bool headset);

enum class KeyHeading { torch, playing, weld, camera, looking, program, count };

/// A line of the list.
struct KeyRow {
    KeyHeading heading = KeyHeading::program;
    std::array<Key, 4> keys{}; ///< the first `count` count
    size_t count = 0;
    std::string_view name; ///< phrase that names keys or mouse; empty: the names of `keys`
    std::string_view what; ///< phrase of the effect
    std::string_view hint; ///< phrase of the effect in the status bar; empty: not there
    std::string_view pad;  ///< phrase that names the gamepad's part with this effect; empty: none

    std::span<const Key> used() const { return std::span(keys).first(count); }
};

/// The lines for a situation; those of the status bar in the order of their weight.
class KeyGuide {
  public:
    explicit KeyGuide(const KeySituation& situation);
    std::span<const KeyRow> rows() const { return std::span(rows_).first(count_); }

  private:
    void add(const KeyRow& row, std::string_view pad = {});
    void addMenus(const KeySituation& now);
    void addTorch(const KeySituation& now);
    void addPlaying(const KeySituation& now);
    void addWeld(const KeySituation& now);
    void addMouse(const KeySituation& now);
    void addCamera(const KeySituation& now);
    void addProgram(const KeySituation& now);

    GamepadUse use_ = GamepadUse::menus;
    std::array<KeyRow, 40> rows_{};
    size_t count_ = 0;
};

/// Name of a row's keys on this keyboard, or of the gamepad's part if the gamepad was used last; empty if it has none.
ShortText keyRowName(const Context& context, const KeyRow& row);

} // namespace meltpool::ui
