// What a person must be told while they weld, in one sentence each for window and headset: why there is no arc, that
// the metal is slow, and that an attempt is not recorded.
#pragma once

#include "app/session/lesson_figures.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"
#include "app/session/trigger_lock.hpp"

#include <string>
#include <string_view>

namespace meltpool {

/// Why an arc that the trigger asks for does not burn; empty: it does, or nobody asks.
class ArcNotice {
  public:
    /// s that an arc may take to strike, and a wire may stub, before a word is said.
    static constexpr double kPatience = 0.5;

    /// Takes the state of the last step. `elapsed`: real seconds since the last call.
    std::string_view update(const ArcState& arc, Striking striking, double elapsed);

  private:
    double waiting_ = 0; ///< s that the arc has not struck, or the wire has stubbed
};

/// Whether the metal runs slower than the person's hand.
class SlowNotice {
  public:
    static constexpr double kSlow = 0.95, kKeepsUp = 0.97; ///< of real time
    static constexpr double kPatience = 0.5;               ///< s

    /// A few words for a row of figures; empty: it keeps up. `speed`: of the metal over real time. Both texts are valid
    /// until the next call, which takes their room.
    std::string_view update(double speed, double elapsed);
    /// The same as a sentence, and what it means for the weld; of the last time that there were words.
    std::string_view sentence() const { return sentence_; }

  private:
    std::string text_, sentence_;
    double slowFor_ = 0; ///< s
    bool told_ = false;
};

/// Holds or clears the message "recording", and warns of recordings that were removed. `now`: on the program's clock,
/// s. To be called in each frame. Allocates nothing while nothing changes.
void tellRecordings(RecordingKeeper& recordings, double now, Messages& messages);

class Notices {
  public:
    /// Holds or clears the messages "arc", "ghost", "visor" and kSlowTopic, and sets figures.slow. `lock`: of what
    /// leads the torch. Why the arc is out is a cue: it is told where that is not withheld, and that the trigger is
    /// locked always. Allocates nothing while nothing changes.
    void update(LessonSession& session, LessonFigures& figures, const TriggerLock& lock, double elapsed,
                Messages& messages);

  private:
    ArcNotice arc_;
    SlowNotice slow_;
};

} // namespace meltpool
