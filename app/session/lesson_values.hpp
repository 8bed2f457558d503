// The values of the open lesson: as its file has them, as menus have set them, and as the running metal has them.
#pragma once

#include "app/session/lesson_sections.hpp"
#include "core/training/trainer/trainer.hpp"

#include <optional>
#include <string>

namespace meltpool {

class LessonValues {
  public:
    explicit LessonValues(Lesson lesson);
    LessonValues(const LessonValues&) = delete;
    LessonValues& operator=(const LessonValues&) = delete;

    /// Takes another lesson, with the values of its file; forScore() stays. What sections()
    /// answered before is gone.
    void open(Lesson lesson);

    Lesson& lesson() { return lesson_; }
    const Lesson& lesson() const { return lesson_; }
    LessonSections& sections() { return *sections_; }
    const LessonSections& sections() const { return *sections_; }
    bool forScore() const { return sections_->attempt.forScore; }

    /// The lesson's own settings of the machine. `machineChosen`: the person has others.
    const ProcessSettings& given() const { return given_; }
    bool machineChosen() const;
    /// See Lesson::chosenText().
    std::string chosenText() { return lesson_.chosenText(); }
    /// The workpiece, or the classic metal's particles, are others than the lesson's file says.
    bool workpieceChanged() { return sections_->workpieceChanged(lesson_); }
    /// Settings of the machine that the lesson gives are others than its own.
    bool settingsChanged() const { return sections_->machineChanged(lesson_); }

    /// From now on apply() brings the menus' values to this metal.
    void follow(Trainer& trainer);
    void unfollow();
    bool followed() const { return !wanted_.empty(); }
    /// Makes the changes that the menus made since the last call.
    void apply(Trainer& trainer);

  private:
    ProcessSettings given_;
    Lesson lesson_;
    std::optional<LessonSections> sections_; ///< of lesson_; always there
    ParameterList wanted_;                   ///< the live values of metal and process as the menus have them
    ParameterList running_;                  ///< those of the running metal
};

} // namespace meltpool
