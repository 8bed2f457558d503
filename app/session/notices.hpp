// Notices for a person while they weld, one sentence each for window and headset: why there is no arc, that the metal
// is slow, and that an attempt is not recorded.
#pragma once

#include "app/session/lesson_figures.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"
#include "app/session/trigger_lock.hpp"

#include <string>
#include <string_view>

namespace meltpool {

/// Reason why an arc that the trigger asks for does not burn; empty: it burns, or the trigger is not pulled.
class ArcNotice {
  public:
    /// s that an arc may take to strike, and a wire may stub, before a notice.
    static constexpr double kPatience = 0.5;

    /// Takes the state of the last step and returns the notice. `elapsed`: s of real time since the last call.
    std::string_view update(const ArcState& arc, Striking striking, double elapsed);

  private:
    double waiting_ = 0; ///< s that the arc has failed to strike, or the wire has stubbed
};

/// Notice that the metal runs slower than the person's hand: a figure as long as it does, and a sentence once an
/// attempt. Metal that only cools after the arc has no hand to follow, and gives neither.
class SlowNotice {
  public:
    static constexpr double kSentence = 10;                ///< s for which an attempt shows the sentence
    static constexpr double kSlow = 0.95, kKeepsUp = 0.97; ///< limits as shares of real time
    static constexpr double kPatience = 0.5;               ///< s

    /// Returns a few words for a row of figures; empty: it keeps up. `speed`: of the metal over real time. `burns`: the
    /// torch heats the metal. `key`: of the sentence. Both texts are valid until the next call, which reuses their
    /// memory.
    std::string_view update(double speed, bool burns, double elapsed, std::string_view key = "notice.slow.sentence");
    /// Sentence for the last words, with the consequence for the weld; empty once the attempt has shown it.
    std::string_view sentence() const { return sentence_; }
    /// Starts another attempt, in which the sentence may be shown again. Keeps the texts' memory.
    void reset() {
        slowFor_ = sentenceFor_ = 0;
        told_ = burned_ = false;
    }

  private:
    std::string text_, sentence_;
    double slowFor_ = 0;     ///< s
    double sentenceFor_ = 0; ///< s for which this attempt has shown the sentence
    bool told_ = false;
    bool burned_ = false; ///< in this attempt
};

/// Holds or clears the message "recording", and warns of recordings that were removed. `now`: s on the program's clock.
/// Call it in each frame. Allocates nothing while nothing changes.
void tellRecordings(RecordingKeeper& recordings, double now, Messages& messages);

/// Notice before the arc of an attempt that cues are hidden, and the key that shows them.
class HiddenCuesNotice {
  public:
    /// Returns the notice; empty: none is hidden, or the arc has burned.
    std::string_view update(const AttemptCues& cues);

  private:
    CueSet told_;
    std::string sentence_;
};

class Notices {
  public:
    /// Holds or clears the messages "arc", "cues", "ghost", "visor" and kSlowTopic, and sets figures.slow. `lock`: of
    /// the torch's leader. The reason of a missing arc is a cue: it appears unless cues are withheld; a locked trigger
    /// is always shown. Allocates nothing while nothing changes.
    void update(LessonSession& session, LessonFigures& figures, const TriggerLock& lock, double elapsed,
                Messages& messages);

  private:
    ArcNotice arc_;
    SlowNotice slow_;
    HiddenCuesNotice hiddenCues_;
    double time_ = 0; ///< simulated time of the last call, s: it falls to 0 with a new attempt
};

} // namespace meltpool
