// The part of LessonSession that measures the machine's speed before an attempt for score.
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"
#include "core/base/words.hpp"

namespace meltpool {

/// Makes the metal of the trial's current offer, and finds when its demonstration begins to heat.
void LessonSession::beginTrial() {
    makeMetal();
    SpeedTrial& trial = activities_.trial;
    beginOver(trial);
    question_ = {};
    const std::string& change = trial.current().label;
    question_.text =
        change.empty() ? phrase("session.measuring") : phrase("session.measuring_with", {{"change", change}});
    trial.beginOffer(lesson());
}

void LessonSession::nextTrial(SpeedTrial::Verdict verdict) {
    while (verdict == SpeedTrial::Verdict::another) {
        try {
            return beginTrial();
        } catch (const InputError&) { // a workpiece may be too small for such coarse particles
            verdict = activities_.trial.skip();
        }
    }
    if (verdict == SpeedTrial::Verdict::tooSlow) question_ = activities_.trial.question();
    if (verdict != SpeedTrial::Verdict::fastEnough) return;
    makeMetal();
    beginAttempt();
}

void LessonSession::settleTrial(int answer, Controls& controls) {
    SpeedTrial& trial = activities_.trial;
    const SpeedOffer offer = trial.fitting() != nullptr ? *trial.fitting() : SpeedOffer{};
    const int test = offer.label.empty() ? -1 : 0; // number of the answer that starts the test
    trial.stop();
    if (answer == test) {
        for (const auto& [key, value] : offer.values)
            values_.lesson().set(key, value, "an offered value");
        begin(controls);
    } else if (answer == test + 1) {
        sections().attempt.forScore = false;
        begin(controls);
    } else {
        end("start menu");
        controls.restart();
    }
}

} // namespace meltpool
