#include "app/session/lesson_values.hpp"

#include <algorithm>
#include <utility>

namespace meltpool {

namespace {

/// Lesson with its machine set as the trainee finds it.
Lesson machineAtStart(Lesson lesson) {
    lesson.takeStartSettings();
    return lesson;
}

bool sameSettings(ProcessSettings a, ProcessSettings b) {
    const ParameterList first = describe(a), second = describe(b);
    return a.kind == b.kind && std::equal(first.begin(), first.end(), second.begin(), second.end(), sameValue);
}

} // namespace

LessonValues::LessonValues(Lesson lesson)
    : given_(lesson.process), lesson_(machineAtStart(std::move(lesson))), sections_(std::in_place, lesson_) {}

void LessonValues::open(Lesson lesson) {
    given_ = lesson.process;
    lesson_ = machineAtStart(std::move(lesson));
    sections_.emplace(lesson_);
}

bool LessonValues::machineChosen() const {
    return !lesson_.choose.empty() && !sameSettings(lesson_.process, given_);
}

void LessonValues::follow(Trainer& trainer) {
    menuValues_ = liveParameters(lesson_.metalParameters());
    liveValues_ = liveParameters(trainer.lesson().metalParameters());
}

void LessonValues::unfollow() {
    menuValues_.clear();
    liveValues_.clear();
}

void LessonValues::apply(Trainer& trainer) {
    for (size_t i = 0; i < menuValues_.size(); ++i)
        if (!sameValue(menuValues_[i], liveValues_[i]))
            trainer.change(menuValues_[i].key, parameterText(menuValues_[i]), "the menu");
}

} // namespace meltpool
