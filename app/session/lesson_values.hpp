// The values of the open lesson: those of its file, those set in menus, and those of the running metal.
#pragma once

#include "app/session/lesson_sections.hpp"
#include "core/training/lesson/handed_path.hpp"
#include "core/training/trainer/trainer.hpp"

#include <optional>
#include <string>

namespace meltpool {

class LessonValues {
  public:
    explicit LessonValues(Lesson lesson);
    LessonValues(const LessonValues&) = delete;
    LessonValues& operator=(const LessonValues&) = delete;

    /// Takes another lesson, with the values of its file, for practice. Earlier results of sections() become
    /// invalid.
    void open(Lesson lesson);

    Lesson& lesson() { return lesson_; }
    const Lesson& lesson() const { return lesson_; }
    LessonSections& sections() { return *sections_; }
    const LessonSections& sections() const { return *sections_; }
    bool forScore() const { return sections_->attempt.forScore; }

    /// The lesson's own settings of the machine. `machineChosen`: the person has changed them.
    const ProcessSettings& given() const { return given_; }
    bool machineChosen() const;
    /// See Lesson::chosenText().
    std::string chosenText() { return lesson_.chosenText(); }
    /// True if the workpiece, or the classic metal's particles, differ from the lesson's file.
    bool workpieceChanged() { return sections_->workpieceChanged(lesson_); }
    /// True if settings of the machine that the lesson gives differ from its own.
    bool settingsChanged() const { return sections_->machineChanged(lesson_); }

    /// Takes the hand that holds a tracked torch: demonstration and expert's ghost weld in its direction from the next
    /// attempt on. Empty: the torch is led at the desk.
    void takeHand(std::optional<WeldingHand> hand) { hand_ = hand; }
    /// Path of demonstration and ghost: see pathForHand(); at the desk the lesson's own.
    TorchPath pathOfExpert() const { return hand_ ? pathForHand(lesson_, *hand_) : lesson_.torch; }

    /// Connects this metal: apply() brings the menus' values to it.
    void follow(Trainer& trainer);
    void unfollow();
    bool followed() const { return !menuValues_.empty(); }
    /// Applies the menus' changes since the last call.
    void apply(Trainer& trainer);

  private:
    ProcessSettings given_;
    Lesson lesson_;
    std::optional<WeldingHand> hand_;
    std::optional<LessonSections> sections_; ///< sections of lesson_; never empty
    ParameterList menuValues_;               ///< live values of metal and process in the menus
    ParameterList liveValues_;               ///< live values of the running metal
};

} // namespace meltpool
