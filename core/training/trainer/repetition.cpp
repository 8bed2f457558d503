#include "core/training/trainer/repetition.hpp"

#include "core/base/text.hpp"

namespace meltpool {

namespace {

/// A text of a file as a terminal may show it.
std::string shown(const std::string& text) {
    return text.empty() ? "an unnamed one" : quote(text);
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
        return "The metal ended in the same bits as in the record.";
    case Repetition::simulation:
        return std::string(told ? "The metal did not end in the bits of the record: this"
                                : "The record names no state for this end, and it was made by another program or "
                                  "driver: this") +
               " is a simulation of the recording. It was made with driver " + shown(attempt.head.driver) +
               " and program " + shown(attempt.head.program) + "; this is driver " + shown(driver) + " and program " +
               shown(program) + ".";
    case Repetition::unchecked:
        break;
    }
    return attempt.stateHash.empty()
               ? "The record names no state at its end, as it ended without warning: nothing to check the metal by."
               : "The repetition is not as long as the attempt: the state at its end is not checked.";
}

} // namespace meltpool
