#include "app/activities/attempt.hpp"

namespace meltpool {

namespace {

/// True if the weld is accepted, or scored in a lesson without limits of acceptance.
bool passed(const Judgement& judgement) {
    if (judgement.verdict) return judgement.verdict->accepted;
    return judgement.score && judgement.score->scored;
}

} // namespace

void Attempt::open(const Lesson& lesson) {
    cues_.open(lesson);
    ghost_.open(lesson);
}

std::string Attempt::begin(Trainer& trainer, bool forScore) {
    judge_.forget();
    cues_.begin();
    ghost_.begin(trainer);
    std::string fault = log_.begin(trainer, trainer.technique() != nullptr && !forScore);
    if (forScore) trainer.event("for_score", "yes");
    return fault;
}

void Attempt::end() {
    tellJudgement();
    judge_.forget();
    log_.redo().begin();
}

void Attempt::reset(Trainer& trainer) {
    tellJudgement();
    trainer.reset();
    log_.close();
    log_.records().check(trainer); // checks the last lines of the record that ended
}

void Attempt::tellJudgement() {
    log_.judged(judge_.judged() ? &judge_.judged()->judgement : nullptr);
}

std::optional<int> Attempt::due(ActivityFrame& frame) {
    if (!frame.waits && !frame.stopped) return frame.clock.due(frame.seconds, frame.trainer->timeStep(), frame.beside);
    frame.clock.restart();
    return std::nullopt;
}

void Attempt::step(ActivityFrame& frame, int step, int steps) {
    Trainer& trainer = *frame.trainer;
    if (step == 0 && frame.clock.dropped() && trainer.arc().burns())
        trainer.event("samples", droppedText(steps * trainer.timeStep()));
    trainer.setRealTime(frame.clock.speed());
    TorchSample torch = frame.torch(step, steps);
    // The other hand may be in sight without a rod in it.
    if (!holdsRod(trainer.lesson().process)) torch.rod.reset();
    trainer.advance(torch, frame.profiler);
}

void Attempt::finish(ActivityFrame& frame) {
    Trainer& trainer = *frame.trainer;
    log_.keepCheckpoint(trainer, frame.clock.speedOfSteps(trainer.timeStep()));
    cues_.update(trainer, frame.forScore, frame.seconds);
    const auto& bands = trainer.lesson().technique;
    ghost_.update(trainer, frame.forScore, cues_.strength(bands ? &*bands : nullptr), frame.seconds);
    if (!judge_.update(trainer)) return;
    judge(trainer);
    frame.clock.restart(); // the metal does not catch up on the time that judging took
}

void Attempt::judge(const Trainer& trainer) {
    judge_.judge(trainer, cues_.heldByDesk());
    if (const auto& judged = judge_.judged(); judged && judged->judgement.score && log_.redo().redone() == 0)
        cues_.practised(*judged->judgement.score);
}

bool Attempt::finishWeld(Trainer& trainer) {
    if (!judge_.waits(trainer)) return false;
    constexpr int kMostSteps = 100; // a wire burns back within a few
    for (int i = 0; i < kMostSteps && trainer.arc().burns(); ++i) {
        TorchSample released = trainer.torch();
        released.trigger = 0;
        trainer.advance(released, nullptr);
    }
    judge(trainer);
    return judge_.judged().has_value();
}

bool Attempt::beginFromCheckpoint(Trainer& trainer, std::string& fault) {
    const auto moment = log_.redo().target(trainer);
    if (!moment) return false;
    if (log_.redo().redone() == 0 && judge_.judged() && passed(judge_.judged()->judgement)) {
        tellJudgement();
        fault = log_.fork(trainer);
    }
    log_.redo().back(trainer, *moment);
    judge_.forget();
    return true;
}

} // namespace meltpool
