// Decides when the workshop is placed in front of the person again.
#pragma once

#include "app/headset/workshop.hpp"

#include <optional>

namespace meltpool {

/// The person in one frame, as far as the place of the workshop depends on them.
struct PersonInFrame {
    std::optional<xr::Pose> head = {}; ///< in the session's space; empty: not tracked
    std::optional<bool> worn = {};     ///< news of the runtime: the headset was put on (true) or taken off
    bool spaceMoved = false;           ///< news of the runtime: its own recentre moved the session's space
    bool buttonHeld = false;           ///< a hand holds the button for it down
    bool handsAct = false;             ///< a hand moves, or presses something
};

/// The workshop is due in these cases:
/// - The first head is located.
/// - The headset was put on: the runtime says so, or a head that lay still beside its controllers moves. It must be far
///   from the last place, so that somebody who only lifts the visor finds the work where it was.
/// - The person has gone far away.
/// - The system's own recentre moved the space.
/// - The button is held for a second, or request() was called.
/// A head that is being put on, or walks, is waited for until it is calm.
class WorkshopPlacing {
  public:
    static constexpr double kHold = 1;   ///< s that the button must be held
    static constexpr double kRest = 8;   ///< s without any motion after which headset and controllers lie on a desk
    static constexpr double kCalm = 0.5; ///< s of calm before a place is taken
    static constexpr double kLongestWait = 4;   ///< s after which a restless head counts as calm
    static constexpr float kFarAway = 2;        ///< m from the workpiece, level
    static constexpr float kOtherPlace = 0.35f; ///< m from the last place, level: another standing place
    static constexpr float kOtherHeight = 0.1f; ///< m: another person, or one who sat down

    /// Takes a frame; `elapsed`: real seconds since the last one. `workshop`: its present place.
    void update(const PersonInFrame& person, const Workshop& workshop, double elapsed);
    /// Asks for the place in front of the person, at once.
    void request() { due_ = true; }
    bool due() const { return due_; }
    /// Notes that the workshop was placed in front of this head.
    void placed(const xr::Pose& head);
    /// Seconds for which the button has been held, up to kHold; 0 once it has acted.
    double held() const { return acted_ ? 0 : held_; }

  private:
    void takeButton(bool held, double elapsed);
    void takeRest(const PersonInFrame& person, double elapsed);
    bool calm(const xr::Pose& head, double elapsed);
    bool elsewhere(const xr::Pose& head, const Workshop& workshop) const;

    bool due_ = true;
    bool putOn_ = false;     ///< the headset was put on and no place was taken since
    bool knowsWorn_ = false; ///< the runtime tells whether the headset is worn
    double held_ = 0;
    bool acted_ = false;             ///< the button has acted in this press
    std::optional<xr::Pose> anchor_; ///< the head as it began to rest
    double rested_ = 0;
    std::optional<xr::Pose> last_; ///< the head in the last frame
    double calmFor_ = 0;
    double waited_ = 0;
    float placedHeight_ = 0; ///< m, height of the head at the last placing, in the session's space
};

} // namespace meltpool
