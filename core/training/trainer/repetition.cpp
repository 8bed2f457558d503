#include "core/training/trainer/repetition.hpp"

#include "core/base/text.hpp"
#include "core/base/words.hpp"

namespace meltpool {

namespace {

/// Text from a file, made safe for a terminal.
std::string shown(const std::string& text) {
    return text.empty() ? phrase("run.repetition.unnamed") : quote(text);
}

} // namespace

Repetition repetitionOf(const RecordedAttempt& attempt, const LessonResult& result, const std::string& program,
                        const std::string& driver) {
    if (const auto same = sameEnd(attempt, result.steps, result.stateHash))
        return *same ? Repetition::sameBits : Repetition::simulation;
    const bool other = attempt.head.driver != driver || attempt.head.program != program;
    return other ? Repetition::simulation : Repetition::unchecked;
}

std::string_view nameOf(Repetition repetition) {
    switch (repetition) {
    case Repetition::sameBits:
        return "same bits";
    case Repetition::simulation:
        return "simulation of the recording";
    case Repetition::unchecked:
        break;
    }
    return "not checked";
}

std::string repetitionText(const RecordedAttempt& attempt, const LessonResult& result, const std::string& program,
                           const std::string& driver) {
    const bool told = sameEnd(attempt, result.steps, result.stateHash).has_value();
    switch (repetitionOf(attempt, result, program, driver)) {
    case Repetition::sameBits:
        return phrase("run.repetition.same");
    case Repetition::simulation:
        return phrase(told ? "run.repetition.other_end" : "run.repetition.other_maker",
                      {{"made_driver", shown(attempt.head.driver)},
                       {"made_program", shown(attempt.head.program)},
                       {"driver", shown(driver)},
                       {"program", shown(program)}});
    case Repetition::unchecked:
        break;
    }
    return phrase(attempt.stateHash.empty() ? "run.repetition.no_state" : "run.repetition.shorter");
}

} // namespace meltpool
