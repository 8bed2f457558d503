// The judgement of the running attempt: made on request, and automatically once a weld is finished.
#pragma once

#include "app/activities/judgement_rows.hpp"
#include "core/training/judging/bend_test.hpp"
#include "core/training/trainer/trainer.hpp"

#include <limits>
#include <optional>

namespace meltpool {

/// Attempt as it was at the time of its judgement.
struct JudgedAttempt {
    Judgement judgement;
    JudgementRows rows;
    std::optional<BendTest> bend; ///< bend test of a weld that has one
    double time = 0;              ///< s of the metal's time at which it was judged
};

/// Holds the judgement until the arc burns again or another attempt begins: it applies to the weld up to that time.
class AttemptJudge {
  public:
    /// s of the metal's time without an arc after which a weld counts as finished.
    static constexpr double kFinished = 1;
    /// m of seam that the arc must have passed over before a weld is judged automatically.
    static constexpr double kLeastWeld = 10e-3;

    /// Takes the last step of a frame. Returns true once when a weld is finished that the lesson judges by technique
    /// bands or an acceptance. Allocates nothing and never waits.
    bool update(const Trainer& trainer);
    /// True if there is a weld that update() would judge once its arc is out for a second.
    bool waits(const Trainer& trainer) const;
    /// Judges the attempt so far. No-op while the arc burns and in the classic model. Waits for the GPU. `held`:
    /// quantities that the desk held.
    void judge(const Trainer& trainer, const QuantitySet& held);
    /// Clears the judgement for another attempt.
    void forget();

    const std::optional<JudgedAttempt>& judged() const { return judged_; }
    /// Count of judgements; it grows when there is a new one to show.
    size_t count() const { return count_; }

  private:
    static constexpr double kNowhere = std::numeric_limits<double>::infinity();

    std::optional<JudgedAttempt> judged_;
    size_t count_ = 0;
    bool due_ = false;       ///< true: welded since the last judgement
    double lastBurned_ = 0;  ///< s of the metal's time
    double from_ = kNowhere; ///< m along the seam, least place of the arc so far
    double to_ = -kNowhere;  ///< m, greatest place of the arc so far
};

} // namespace meltpool
