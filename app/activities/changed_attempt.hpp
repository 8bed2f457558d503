// An attempt welded again with one thing changed: first as it was, to learn the hand step by step, then with the
// change.
#pragma once

#include "core/training/lesson/changed_path.hpp"
#include "core/training/trainer/trainer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace meltpool {

class ChangedAttempt {
  public:
    /// `wish`: as readWhatIf() takes it, such as "voltage=20". `words`: the wish for people. Throws InputError for a
    /// wish that does not fit the lesson.
    ChangedAttempt(const Lesson& lesson, const std::string& wish, std::string words);

    const std::string& words() const { return words_; }

    /// Makes a step of the unchanged attempt and notes the hand.
    void stepOriginal(Trainer& trainer);
    /// Changes the lesson for the second weld, after the whole of the first one. `original`: its judgement, for its
    /// mean travel speed. Throws InputError if the change needs a travel speed that is not known.
    void change(Lesson& lesson, const Judgement& original);
    /// Makes a step of the changed attempt.
    void stepChanged(Trainer& trainer) const;
    /// Length of the changed attempt, s; 0 before change().
    double duration() const { return path_ ? path_->duration() : 0; }

  private:
    WhatIf whatIf_;
    std::string words_;
    std::vector<AttemptStep> steps_;
    std::optional<ChangedPath> path_;
};

} // namespace meltpool
