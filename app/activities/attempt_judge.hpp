// The judgement of the running attempt: made when somebody asks for it, and by itself once a weld is finished.
#pragma once

#include "app/activities/judgement_rows.hpp"
#include "core/training/judging/bend_test.hpp"
#include "core/training/trainer/trainer.hpp"

#include <limits>
#include <optional>

namespace meltpool {

/// The attempt as it was at one moment.
struct JudgedAttempt {
    Judgement judgement;
    JudgementRows rows;
    std::optional<BendTest> bend; ///< of welds that such a test is made of
    double time = 0;              ///< s of the metal's time at which it was judged
};

/// Keeps the judgement until the arc burns again or another attempt begins: it stands for what was welded until then.
class AttemptJudge {
  public:
    /// s of the metal's time without an arc after which a weld counts as finished.
    static constexpr double kFinished = 1;
    /// m of seam that the arc must have passed over before a weld is judged unasked.
    static constexpr double kLeastWeld = 10e-3;

    /// Takes the last step of a frame. True once when a weld is finished that the lesson judges by technique bands or
    /// an acceptance. Allocates nothing and never waits.
    bool update(const Trainer& trainer);
    /// Judges the attempt so far. Nothing while the arc burns and in the classic model. Waits for the GPU.
    void judge(const Trainer& trainer);
    /// Another attempt begins.
    void forget();

    const std::optional<JudgedAttempt>& judged() const { return judged_; }
    /// Judgements made so far: it grows when there is a new one to be shown.
    size_t count() const { return count_; }

  private:
    static constexpr double kNowhere = std::numeric_limits<double>::infinity();

    std::optional<JudgedAttempt> judged_;
    size_t count_ = 0;
    bool due_ = false;       ///< welded since the last judgement
    double lastBurned_ = 0;  ///< s, of the metal's time
    double from_ = kNowhere; ///< m along the seam, the least place that the arc has been at
    double to_ = -kNowhere;  ///< the greatest
};

} // namespace meltpool
