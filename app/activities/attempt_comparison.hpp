// Two kept attempts of a lesson, welded again one after the other a frame's share at a time and held against each
// other.
#pragma once

#include "app/activities/activity.hpp"
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
#include <vector>

namespace meltpool {

/// An attempt that was welded again, and what came of it.
struct ComparedAttempt {
    std::filesystem::path file;
    std::uintmax_t bytes = 0; ///< of the file, so that one that grew is welded anew
    Judgement judgement;
    AttemptFigures figures;
    ReplayEnd end; ///< whether it is the attempt to the last bit
};

/// Goes on beside the list of attempts, outside a lesson: it makes the metal of both itself.
class AttemptComparison final : public Activity {
  public:
    static constexpr size_t kKept = 6; ///< attempts whose results stay known

    /// One of the two as the list has it.
    struct Side {
        std::filesystem::path file;
        std::string detail; ///< when, how long, what score
    };

    /// Reads both; nothing is welded yet. Throws InputError where they are no two attempts at the same weld lesson, and
    /// what lessonOfAttempt() throws; what was shown before stays then.
    void begin(const Side& first, const Side& second);
    /// Frees the metal and forgets both; results that are whole stay known.
    void end();

    bool inLesson() const override { return false; }
    Allowed allowed() const override { return {}; }
    NextAttempt nextAttempt(bool) const override { return NextAttempt::none; }
    bool hurries() const override { return welding(); }
    /// Makes the steps of the frame itself, see update().
    std::optional<int> due(ActivityFrame& frame) override;
    void step(ActivityFrame&, int, int) override {}
    void finish(ActivityFrame&) override {}

    /// Steps are still to be made.
    bool welding() const { return fault_.empty() && !rows_ && lessons_[current()].has_value(); }
    /// A frame's share of the welding; `seconds`: of the last frame. The first one of each attempt makes its
    /// metal and its last one waits for the GPU. Read fault() for what went wrong.
    void update(gl::ShaderLibrary& shaders, double seconds, Stopwatch now);

    /// 0..1 of all the welding that there was to do.
    double progress() const;
    /// Which of both is welded, 0 or 1.
    size_t current() const { return sides_[0] ? 1 : 0; }
    /// Why it cannot go on; empty while it can.
    const std::string& fault() const { return fault_; }

    const std::string& lesson() const { return title_; }
    const Side& side(size_t number) const { return chosen_[number]; }
    /// What the lesson asks of the hand; null where it asks nothing.
    const TechniqueBands* bands() const { return bands_ ? &*bands_ : nullptr; }
    /// The result of each, once it is welded; null before.
    const ComparedAttempt* attempt(size_t number) const { return sides_[number].get(); }
    /// How both differ; nothing before both are welded.
    const std::optional<Comparison>& comparison() const { return comparison_; }
    const std::optional<ComparisonRows>& rows() const { return rows_; }
    /// Attempts that have been welded since the start, for tests.
    size_t welded() const { return welded_; }

  private:
    using Kept = std::shared_ptr<const ComparedAttempt>;

    Kept known(const std::filesystem::path& file, std::uintmax_t bytes) const;
    double share() const;
    bool isOver() const { return share() >= 1; }
    void finishSide();
    void compare();

    std::string title_;
    std::optional<TechniqueBands> bands_;
    std::array<Side, 2> chosen_;
    std::array<std::optional<Lesson>, 2> lessons_; ///< of those that are still to be welded
    std::array<Kept, 2> sides_;
    size_t due_ = 0; ///< attempts that had to be welded for this comparison
    std::optional<Comparison> comparison_;
    std::optional<ComparisonRows> rows_;
    std::string fault_;
    std::vector<Kept> kept_; ///< the newest last
    size_t welded_ = 0;
    SeekPace pace_{0.1};
    std::unique_ptr<Trainer> trainer_; ///< of the attempt that is welded
};

} // namespace meltpool
