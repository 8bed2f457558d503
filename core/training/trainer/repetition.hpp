// Compares a repetition with its recorded attempt: equal bit for bit, or a simulation of its recording.
#pragma once

#include "core/training/trainer/trainer.hpp"

#include <string>

namespace meltpool {

enum class Repetition {
    sameBits,   ///< the metal ended in the recorded state
    simulation, ///< the end differs, or is not recorded and the driver or program is another one
    unchecked,  ///< the recording has no end, or the repetition has another length
};

/// `program` and `driver`: of the present run, as records name them.
Repetition repetitionOf(const RecordedAttempt& attempt, const LessonResult& result, const std::string& program,
                        const std::string& driver);

/// "same bits", "simulation of the recording", "not checked".
std::string_view nameOf(Repetition repetition);

/// A sentence or two for people; for a simulation with both drivers and programs.
std::string repetitionText(const RecordedAttempt& attempt, const LessonResult& result, const std::string& program,
                           const std::string& driver);

} // namespace meltpool
