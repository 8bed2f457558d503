// A person's own attempt: the weld under their torch, with its help, judgement and stored files. It begins over the
// metal at its start, or again from one of its checkpoints: then it is redone.
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

    /// Takes another lesson.
    void open(const Lesson& lesson);
    /// Begins over the metal at its start. An attempt for score is welded once, from its beginning to its end. Returns
    /// the reason why its record cannot be written; empty: it is written, or none is wanted.
    std::string begin(Trainer& trainer, bool forScore);
    /// Begins again from an earlier checkpoint, see Redo::target(): files, cues and ghost go on, the judgement is
    /// dropped. A weld that passed stays an attempt of its own, and its files end: what is welded from here on is
    /// another attempt with the same beginning. `fault` receives the reason why its record cannot be written. False if
    /// there is no such checkpoint. Waits for the GPU.
    bool beginFromCheckpoint(Trainer& trainer, std::string& fault);
    /// Ends the attempt, if there is one, and writes its judgement to its recording.
    void end();
    /// Resets the metal to its start for another attempt, and writes the judgement to the recording of this one.
    void reset(Trainer& trainer);

    /// Judges the attempt so far; no-op while the arc burns and before the attempt begins. Waits for the GPU. A
    /// finished weld is judged automatically, see AttemptJudge. Throws RuntimeFault.
    void judge(const Trainer& trainer);
    /// Lets the arc go out and judges a weld that waits for it, see AttemptJudge::waits(); false if none does. Waits
    /// for the GPU. Throws RuntimeFault.
    bool finishWeld(Trainer& trainer);
    const AttemptJudge& judging() const { return judge_; }
    /// Judgement of the attempt, until the arc burns again or another attempt begins, and the count of judgements.
    const std::optional<JudgedAttempt>& judged() const { return judge_.judged(); }
    size_t judgements() const { return judge_.count(); }
    AttemptLog& log() { return log_; }
    const AttemptLog& log() const { return log_; }
    /// Cues at the torch.
    AttemptCues& cues() { return cues_; }
    const AttemptCues& cues() const { return cues_; }
    /// Ghost: another's torch next to one's own.
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
