// A person's own attempt: the weld under their torch, with the help beside it, its judgement, and what is kept of it.
// It begins over the metal at its start, or again from one of its checkpoints: then it is redone.
#pragma once

#include "app/activities/activity.hpp"
#include "app/activities/attempt_cues.hpp"
#include "app/activities/attempt_ghost.hpp"
#include "app/activities/attempt_judge.hpp"
#include "app/activities/attempt_log.hpp"

#include <optional>
#include <string>

namespace meltpool {

class Attempt final : public Activity {
  public:
    Allowed allowed() const override { return {true, true, true, true, true}; }
    NextAttempt nextAttempt(bool) const override { return NextAttempt::sameMetal; }
    std::optional<int> due(ActivityFrame& frame) override;
    void step(ActivityFrame& frame, int step, int steps) override;
    void finish(ActivityFrame& frame) override;

    /// Another lesson was opened.
    void open(const Lesson& lesson);
    /// Begins over the metal at its start. An attempt for score is welded once, from its beginning to its end. Answers
    /// why its record cannot be written; empty: it is, or none is wanted.
    std::string begin(Trainer& trainer, bool forScore);
    /// Begins again from an earlier moment of its own metal, see Redo::back(): files, cues and ghost go on, the
    /// judgement is forgotten. False where no such moment is kept. Waits for the GPU.
    bool beginFromCheckpoint(Trainer& trainer);
    /// The attempt is over, or there was none: its judgement goes into its recording.
    void end();
    /// Puts the metal back to its start for another attempt; the judgement goes into the recording of this one.
    void reset(Trainer& trainer);

    /// Judges the attempt so far; nothing while the arc burns or before the attempt has begun. Waits for the GPU. A
    /// finished weld is judged without being asked for, see AttemptJudge. Throws RuntimeFault.
    void judge(const Trainer& trainer);
    const AttemptJudge& judging() const { return judge_; }
    /// The judgement of the attempt, until the arc burns again or another attempt begins, and how many there were.
    const std::optional<JudgedAttempt>& judged() const { return judge_.judged(); }
    size_t judgements() const { return judge_.count(); }
    AttemptLog& log() { return log_; }
    const AttemptLog& log() const { return log_; }
    /// Help beside the torch.
    AttemptCues& cues() { return cues_; }
    const AttemptCues& cues() const { return cues_; }
    /// Another's torch beside one's own.
    AttemptGhost& ghost() { return ghost_; }
    const AttemptGhost& ghost() const { return ghost_; }

  private:
    void tellJudgement();

    AttemptLog log_;
    AttemptJudge judge_;
    AttemptCues cues_;
    AttemptGhost ghost_;
};

} // namespace meltpool
