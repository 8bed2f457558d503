#include "app/activities/speed_trial.hpp"

#include "app/library/best_scores.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/weld/workpiece/simulated_size.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr int kFewestCells = 16;
constexpr int kFewestParticles = 512;
constexpr float kCoarsest = 2; ///< mm, coarsest spacing

std::string percent(double ratio) {
    return std::to_string(static_cast<int>(std::lround(100 * ratio))) + " %";
}

/// Next coarser spacing of 0.5, 0.75, 1, 1.5, 2 mm.
float coarser(float spacing) {
    for (const float step : {0.5F, 0.75F, 1.0F, 1.5F, kCoarsest})
        if (step > spacing * 1.2F) return step;
    return spacing;
}

/// Label "slightly coarser metal (1.5 mm)", with the sizes of the workpiece that coarser layers change.
std::string spacingLabel(WorkpieceParameters workpiece, float spacing) {
    workpiece.spacingMm = spacing;
    std::string changed;
    for (const SimulatedSize& size : simulatedSizes(workpiece)) {
        if (!changed.empty()) changed += phrase("list.separator");
        changed +=
            phrase("trial.size." + std::string(size.key), {{"length", withDecimalMark(formatNumber(size.simulated))}});
    }
    return phrase(changed.empty() ? "trial.spacing" : "trial.spacing_and_sizes",
                  {{"spacing", withDecimalMark(formatNumber(spacing))}, {"sizes", changed}});
}

} // namespace

std::vector<SpeedOffer> cheaperValues(const Lesson& lesson) {
    std::vector<SpeedOffer> offers;
    if (const int cells = lesson.surface.cells / 2; cells >= kFewestCells)
        offers.push_back({phrase("trial.cells", {{"cells", PhraseNumber(cells)}}), {{"cells", std::to_string(cells)}}});
    if (lesson.model == LessonModel::Classic) {
        if (const int particles = lesson.setup.particles / 2; particles >= kFewestParticles)
            offers.push_back({phrase("trial.particles", {{"particles", PhraseNumber(particles)}}),
                              {{"particles", std::to_string(particles)}}});
    } else if (const float spacing = coarser(lesson.workpiece.spacingMm); spacing > lesson.workpiece.spacingMm) {
        offers.push_back({spacingLabel(lesson.workpiece, spacing), {{"spacing_mm", formatNumber(spacing)}}});
    }
    if (offers.size() == 2) {
        SpeedOffer both{phrase("trial.both", {{"first", offers[0].label}, {"second", offers[1].label}}),
                        offers[0].values};
        both.values.insert(both.values.end(), offers[1].values.begin(), offers[1].values.end());
        offers.push_back(both);
    }
    return offers;
}

void SpeedTrial::begin(const Lesson& lesson) {
    offers_ = {SpeedOffer{}};
    for (SpeedOffer& offer : cheaperValues(lesson))
        offers_.push_back(std::move(offer));
    current_ = 0;
    waited_ = real_ = simulated_ = 0;
}

/// While it asks how to go on, the lesson is in the state before an attempt. An open result stays open.
Allowed SpeedTrial::allowed() const {
    const bool asks = !measuring();
    return {.ownTorch = true, .values = asks, .help = asks, .judging = true, .notes = asks};
}

std::optional<int> SpeedTrial::due(ActivityFrame& frame) {
    Trainer& trainer = *frame.trainer;
    if (!measuring() || frame.stopped) {
        frame.clock.restart();
        return std::nullopt;
    }
    const double before = time_;
    const int steps = frame.clock.due(frame.seconds, trainer.timeStep());
    const double begin = frame.now();
    for (int step = 0; step < steps; ++step)
        trainer.advance(trainer.lesson().torch.sample(time_ += trainer.timeStep()), frame.profiler);
    frame.clock.took(frame.now() - begin, steps);
    frame.changed = true;
    verdict_ = count(frame.seconds, time_ - before);
    return std::nullopt;
}

SpeedTrial::Verdict SpeedTrial::count(double real, double simulated) {
    waited_ += real;
    if (waited_ < kSettling) return Verdict::more;
    real_ += real;
    simulated_ += simulated;
    if (real_ < kMeasuring) return Verdict::more;
    offers_[current_].ratio = simulated_ / real_;
    const bool first = current_ == 0;
    if (first && offers_[0].ratio >= kLeastSpeedForScore) {
        stop();
        return Verdict::fastEnough;
    }
    ++current_;
    if (fitting() != nullptr) current_ = offers_.size(); // the others would change more than they must
    waited_ = real_ = simulated_ = 0;
    return measuring() ? Verdict::another : Verdict::tooSlow;
}

SpeedTrial::Verdict SpeedTrial::skip() {
    offers_.erase(offers_.begin() + static_cast<std::ptrdiff_t>(current_));
    return measuring() ? Verdict::another : Verdict::tooSlow;
}

const SpeedOffer* SpeedTrial::fitting() const {
    const auto found = std::find_if(offers_.begin(), offers_.end(), [](const SpeedOffer& offer) {
        return !offer.label.empty() && offer.ratio >= kLeastSpeedForScore;
    });
    return found == offers_.end() ? nullptr : &*found;
}

Question SpeedTrial::question() const {
    const SpeedOffer* const fits = fitting();
    Question question;
    question.text = phrase(fits != nullptr ? "trial.question" : "trial.no_test",
                           {{"speed", percent(offers_.front().ratio)}, {"change", fits ? fits->label : ""}});
    if (fits != nullptr) question.answers.push_back(phrase("trial.answer"));
    question.answers.push_back(phrase("trial.practise"));
    question.answers.push_back(phrase("trial.start_menu"));
    return question;
}

} // namespace meltpool
