// Two people in one lesson, at the desk and in the headset: a question comes before one ends the other's weld, and each
// reads what the other did.
#pragma once

#include "app/activities/question.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/menu_state.hpp"
#include "app/session/messages.hpp"

#include <array>
#include <optional>

namespace meltpool {

/// Place from which a person asks for something.
enum class Seat { desk, headset };

/// True if the request ends the running attempt, or a part of it.
bool endsAttempt(MenuRequest request);

class SeatRequests {
  public:
    /// Both must outlive this.
    SeatRequests(LessonSession& session, Messages& messages) : session_(session), messages_(messages) {}

    /// Takes the frame's state. `inUse`: a headset paces the frame. `deskLeads`: the mouse at the desk is locked to the
    /// torch. A change of the torch's leader goes into the record and to both people. `now`: s on the program's clock.
    void update(bool inUse, bool deskLeads, double now);

    /// Returns true if the request may be carried out at once. If it would end the other person's weld, it returns
    /// false and sets question().
    bool allows(Seat asker, MenuRequest request);
    /// Notes in the record what `asker` does now, and tells the other person. Call it before it is done.
    void note(Seat asker, MenuRequest request, double now);

    /// Question to the person at that place; menu or panel shows it and sets `answered`.
    Question& question(Seat asker) { return pending_[static_cast<size_t>(asker)].question; }
    /// Returns the request whose question was answered with yes; none: no question was.
    MenuRequest takeConfirmed(Seat asker);

  private:
    struct Pending {
        Question question;
        MenuRequest request = MenuRequest::none;
    };

    bool endsWeldOfOther(Seat asker) const;

    LessonSession& session_;
    Messages& messages_;
    std::array<Pending, 2> pending_; ///< indexed by Seat
    bool inUse_ = false;
    std::optional<bool> deskLeads_; ///< empty: no headset in use, or no lesson
    bool welded_ = false;           ///< the arc has burned in this attempt
    size_t steps_ = 0;
};

} // namespace meltpool
