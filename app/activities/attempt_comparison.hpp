// The comparison of two stored attempts at a lesson, each welded again, one after the other, a share per frame.
#pragma once

#include "app/activities/activity.hpp"
#include "app/activities/changed_attempt.hpp"
#include "app/activities/comparison_rows.hpp"
#include "app/activities/replay_end.hpp"
#include "app/activities/seek_pace.hpp"
#include "core/training/trainer/trainer.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meltpool {

/// Result of an attempt that was welded again.
struct ComparedAttempt {
    std::filesystem::path file;
    std::uintmax_t bytes = 0; ///< size of the file, so that one that grew is welded again
    Judgement judgement;
    AttemptFigures figures;
    ReplayEnd end; ///< comparison with the recording's bits
};

/// Comparison of two attempts. It runs on the list of attempts, outside a lesson, and makes the metal of both itself.
class AttemptComparison final : public Activity {
  public:
    static constexpr size_t kKept = 6; ///< count of stored results

    /// One of the two as the list shows it.
    struct Side {
        std::filesystem::path file;
        std::string detail; ///< date, duration and score
    };

    /// Reads both; welds nothing yet. Throws InputError unless they are two attempts at one weld lesson, and whatever
    /// lessonOfAttempt() throws; the earlier comparison then stays.
    void begin(const Side& first, const Side& second);
    /// Chooses the change that tryChange() makes: a wish for readWhatIf(), and its words.
    void choose(std::string wish, std::string words) { wish_ = {std::move(wish), std::move(words)}; }
    /// Reads the attempt; the second side is this attempt with the chosen change. Both are welded. Throws as begin()
    /// does, and InputError for a change that does not fit.
    void tryChange(const Side& attempt);
    /// Frees the metal and clears both; complete results stay stored.
    void end();

    bool inLesson() const override { return false; }
    Allowed allowed() const override { return {}; }
    NextAttempt nextAttempt(bool) const override { return NextAttempt::none; }
    bool hurries() const override { return welding(); }
    /// Makes the steps of the frame itself, see update().
    std::optional<int> due(ActivityFrame& frame) override;
    void step(ActivityFrame&, int, int) override {}
    void finish(ActivityFrame&) override {}

    /// True while steps remain to be made.
    bool welding() const { return fault_.empty() && !rows_ && lessons_[current()].has_value(); }
    /// Welds a frame's share; `seconds`: of the last frame. The first share of each attempt makes its metal and its
    /// last one waits for the GPU. A failure is in fault().
    void update(gl::ShaderLibrary& shaders, double seconds, Stopwatch now);

    /// Share of all the welding that is done, 0..1.
    double progress() const;
    /// Index of the attempt being welded, 0 or 1.
    size_t current() const { return sides_[0] ? 1 : 0; }
    /// Reason why it cannot go on; empty while it can.
    const std::string& fault() const { return fault_; }

    const std::string& lesson() const { return title_; }
    const Side& side(size_t number) const { return chosen_[number]; }
    /// Technique that the lesson asks for; null if none.
    const TechniqueBands* bands() const { return bands_ ? &*bands_ : nullptr; }
    /// Result of each, once it is welded; null before.
    const ComparedAttempt* attempt(size_t number) const { return sides_[number].get(); }
    /// Differences of the two; nothing before both are welded.
    const std::optional<Comparison>& comparison() const { return comparison_; }
    const std::optional<ComparisonRows>& rows() const { return rows_; }
    /// Count of attempts welded since the start, for tests.
    size_t welded() const { return welded_; }

  private:
    using SharedAttempt = std::shared_ptr<const ComparedAttempt>;

    SharedAttempt known(const std::filesystem::path& file, std::uintmax_t bytes) const;
    void makeMetal(gl::ShaderLibrary& shaders);
    void makeStep();
    /// True while the attempt is welded with the change.
    bool changes() const { return changed_.has_value() && current() == 1; }
    double share() const;
    bool isOver() const { return share() >= 1; }
    void finishSide();
    void compare();

    std::string title_;
    std::optional<TechniqueBands> bands_;
    std::array<Side, 2> chosen_;
    std::pair<std::string, std::string> wish_;     ///< chosen change, and its words
    std::optional<ChangedAttempt> changed_;        ///< the second side is the first one with a change
    std::array<std::optional<Lesson>, 2> lessons_; ///< lessons of the attempts still to be welded
    std::array<SharedAttempt, 2> sides_;
    size_t due_ = 0; ///< count of attempts that had to be welded for this comparison
    std::optional<Comparison> comparison_;
    std::optional<ComparisonRows> rows_;
    std::string fault_;
    std::vector<SharedAttempt> kept_; ///< newest last
    size_t welded_ = 0;
    SeekPace pace_{0.1};
    std::unique_ptr<Trainer> trainer_; ///< trainer of the current attempt
};

} // namespace meltpool
