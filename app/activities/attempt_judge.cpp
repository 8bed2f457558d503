#include "app/activities/attempt_judge.hpp"

#include "core/weld/workpiece/simulated_size.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

bool AttemptJudge::update(const Trainer& trainer) {
    const Technique* technique = trainer.technique();
    if (technique == nullptr) return false;
    if (trainer.arc().burns()) {
        judged_.reset();
        due_ = true;
        lastBurned_ = trainer.time();
        if (std::isfinite(technique->place())) {
            from_ = std::min(from_, technique->place());
            to_ = std::max(to_, technique->place());
        }
        return false;
    }
    if (!waits(trainer) || trainer.time() - lastBurned_ < kFinished) return false;
    due_ = false;
    return true;
}

bool AttemptJudge::waits(const Trainer& trainer) const {
    const bool asked = trainer.lesson().technique || trainer.lesson().acceptance;
    return due_ && asked && to_ - from_ >= kLeastWeld;
}

void AttemptJudge::judge(const Trainer& trainer, const QuantitySet& held) {
    if (trainer.technique() == nullptr || trainer.arc().burns()) return;
    JudgedAttempt judged;
    judged.judgement = trainer.judge();
    const auto& bands = trainer.lesson().technique;
    judged.rows = judgementRows(judged.judgement, bands ? &*bands : nullptr, held);
    if (const auto& weld = judged.judgement.weld)
        judged.bend =
            bendTest(*weld, static_cast<double>(simulatedWorkpiece(trainer.lesson().workpiece).thicknessMm) * 1e-3);
    judged.time = trainer.time();
    judged_ = std::move(judged);
    due_ = false;
    ++count_;
}

void AttemptJudge::forget() {
    judged_.reset();
    due_ = false;
    from_ = kNowhere;
    to_ = -kNowhere;
}

} // namespace meltpool
