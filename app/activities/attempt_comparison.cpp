#include "app/activities/attempt_comparison.hpp"

#include "app/activities/attempt_lesson.hpp"
#include "core/base/error.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

namespace {

/// Size of a file; 0 if unknown.
std::uintmax_t sizeOf(const std::filesystem::path& file) {
    std::error_code failure;
    const std::uintmax_t bytes = std::filesystem::file_size(file, failure);
    return failure ? 0 : bytes;
}

void requireSame(const Lesson& first, const Lesson& second, const AttemptComparison::Side& other) {
    if (first.model != LessonModel::Weld || second.model != LessonModel::Weld)
        throw InputError(other.file, 0, "has no weld to measure; expected two attempts at one weld lesson");
    if (first.key != second.key || first.file != second.file)
        throw InputError(other.file, 0,
                         "is an attempt at lesson '" + second.key + "'; expected an attempt at '" + first.key + "'");
}

} // namespace

void AttemptComparison::begin(const Side& first, const Side& second) {
    if (first.file == second.file)
        throw InputError(first.file, 0, "cannot be compared with itself; expected two different attempts");
    std::array<std::optional<Lesson>, 2> lessons{lessonOfAttempt(first.file), lessonOfAttempt(second.file)};
    requireSame(*lessons[0], *lessons[1], second);
    end();
    title_ = lessons[0]->title;
    bands_ = lessons[0]->technique;
    chosen_ = {first, second};
    lessons_ = std::move(lessons);
    due_ = 0;
    for (size_t i = 0; i < sides_.size(); ++i) {
        sides_[i] = known(chosen_[i].file, sizeOf(chosen_[i].file));
        if (!sides_[i]) ++due_;
    }
    if (due_ == 0) compare();
}

void AttemptComparison::tryChange(const Side& attempt) {
    Lesson lesson = lessonOfAttempt(attempt.file);
    requireSame(lesson, lesson, attempt);
    ChangedAttempt changed(lesson, wish_.first, wish_.second);
    end();
    title_ = lesson.title;
    bands_ = lesson.technique;
    chosen_ = {attempt, Side{attempt.file, wish_.second}};
    lessons_ = {lesson, std::move(lesson)};
    due_ = sides_.size();
    changed_ = std::move(changed);
}

void AttemptComparison::end() {
    trainer_.reset();
    changed_.reset();
    lessons_ = {};
    sides_ = {};
    comparison_.reset();
    rows_.reset();
    fault_.clear();
}

AttemptComparison::SharedAttempt AttemptComparison::known(const std::filesystem::path& file,
                                                          std::uintmax_t bytes) const {
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const SharedAttempt& kept) {
        return kept->file == file && kept->bytes == bytes && bytes > 0;
    });
    return found == kept_.end() ? SharedAttempt() : *found;
}

std::optional<int> AttemptComparison::due(ActivityFrame& frame) {
    update(frame.shaders, frame.seconds, frame.now);
    return std::nullopt;
}

void AttemptComparison::update(gl::ShaderLibrary& shaders, double seconds, Stopwatch now) {
    if (!welding()) return;
    try {
        if (!trainer_) {
            makeMetal(shaders);
            return pace_.begin(seconds);
        }
        pace_.frame(seconds);
        const double begin = now();
        for (int made = 0; !isOver() && made < pace_.steps() && now() - begin < pace_.slice(); ++made)
            makeStep();
        if (isOver()) finishSide();
    } catch (const std::exception& fault) {
        fault_ = fault.what();
        trainer_.reset();
    }
}

void AttemptComparison::makeMetal(gl::ShaderLibrary& shaders) {
    if (changes()) changed_->change(*lessons_[1], sides_[0]->judgement);
    trainer_ = std::make_unique<Trainer>(shaders, *lessons_[current()]);
}

void AttemptComparison::makeStep() {
    if (!changed_)
        trainer_->advanceDemonstration(nullptr);
    else if (changes())
        changed_->stepChanged(*trainer_);
    else
        changed_->stepOriginal(*trainer_);
}

/// Progress of the current attempt, 1 at its end. A recording ends with its last step, a path with its time.
double AttemptComparison::share() const {
    if (!trainer_) return 0;
    const Lesson& lesson = trainer_->lesson();
    const double whole = changes() ? changed_->duration() : lesson.torch.duration();
    if (!changes() && lesson.recorded && lesson.recorded->rows > 0)
        return static_cast<double>(trainer_->steps()) / static_cast<double>(lesson.recorded->rows);
    const double left = whole - trainer_->time();
    return left <= 0.5 * trainer_->timeStep() ? 1 : trainer_->time() / whole;
}

double AttemptComparison::progress() const {
    if (rows_ || due_ == 0) return 1;
    const bool secondKnown = sides_[1] != nullptr;
    const double done = due_ == 2 && sides_[0] && !secondKnown ? 1 : 0;
    return std::min(1.0, (done + share()) / static_cast<double>(due_));
}

void AttemptComparison::finishSide() {
    const Lesson& lesson = trainer_->lesson();
    ComparedAttempt made;
    made.file = chosen_[current()].file;
    made.bytes = sizeOf(made.file);
    made.judgement = trainer_->judge();
    made.figures = figuresOf(made.judgement, lesson.process);
    made.end = replayEnd(lesson.recorded ? &*lesson.recorded : nullptr, trainer_->steps(), trainer_->result().stateHash,
                         thisMachine());
    trainer_.reset();
    const size_t number = current();
    const bool asWelded = !changes();
    lessons_[number].reset();
    sides_[number] = std::make_shared<const ComparedAttempt>(std::move(made));
    if (asWelded) kept_.push_back(sides_[number]);
    if (kept_.size() > kKept) kept_.erase(kept_.begin());
    ++welded_;
    if (sides_[0] && sides_[1]) compare();
}

void AttemptComparison::compare() {
    comparison_ = compareAttempts(sides_[0]->figures, sides_[1]->figures);
    rows_ = comparisonRows(sides_[0]->judgement, sides_[1]->judgement, *comparison_);
    const auto &before = sides_[0]->judgement.verdict, &then = sides_[1]->judgement.verdict;
    if (changed_ && before && then)
        rows_->words = whatIfOutcome(changed_->words(), failedKeys(*before), failedKeys(*then)) + " " + rows_->words;
    for (size_t i = 0; i < (changed_ ? 1 : sides_.size()); ++i)
        if (const ReplayEnd& end = sides_[i]->end; end.verdict != ReplayEnd::Verdict::same)
            rows_->notes.push_back(
                phrase(i == 0 ? "compared.note.first" : "compared.note.second", {{"sentences", end.text}}));
}

} // namespace meltpool
