// The part of LessonSession that measures, before an attempt for score, whether the machine keeps up.
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"

namespace meltpool {

/// Makes the metal of the trial's current offer, and finds where its demonstration begins to heat.
void LessonSession::beginTrial() {
    makeTrainer();
    fault_.clear();
    surfaceIsOld_ = true;
    question_ = {};
    question_.text = "Measuring whether this machine keeps up with the clock";
    question_.text += trial_.current().label.empty() ? " ..." : ", with " + trial_.current().label + " ...";
    trialTime_ = lesson_.torch.firstPull().value_or(0);
}

void LessonSession::measureSpeed(double seconds, gl::Profiler* profiler) {
    const double before = trialTime_;
    makeDueSteps(seconds, [&](int, int) {
        trainer_->advance(lesson_.torch.sample(trialTime_ += trainer_->timeStep()), profiler);
    });
    surfaceIsOld_ = true;
    nextTrial(trial_.count(seconds, trialTime_ - before));
}

void LessonSession::nextTrial(SpeedTrial::Verdict verdict) {
    while (verdict == SpeedTrial::Verdict::another) {
        try {
            return beginTrial();
        } catch (const InputError&) { // a workpiece may have no room for such coarse particles
            verdict = trial_.skip();
        }
    }
    if (verdict == SpeedTrial::Verdict::tooSlow) question_ = trial_.question();
    if (verdict != SpeedTrial::Verdict::fastEnough) return;
    makeTrainer();
    beginAttempt();
}

void LessonSession::settleTrial(int answer, Controls& controls) {
    const std::vector<SpeedOffer> offers = trial_.offers();
    trial_.stop();
    if (static_cast<size_t>(answer) + 1 < offers.size()) {
        for (const auto& [key, value] : offers[static_cast<size_t>(answer) + 1].values)
            lesson_.set(key, value, "a value that was offered");
        begin(controls);
    } else if (static_cast<size_t>(answer) + 1 == offers.size()) {
        sections_->attempt.forScore = false;
        begin(controls);
    } else {
        end("start menu");
        controls.restart();
    }
}

} // namespace meltpool
