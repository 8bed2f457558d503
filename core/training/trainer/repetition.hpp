// Whether a repetition of a recorded attempt is the attempt, bit for bit, or a simulation of its recording.
#pragma once

#include "core/training/trainer/trainer.hpp"

#include <string>

namespace meltpool {

enum class Repetition {
    sameBits,   ///< the metal ended in the state that the recording names
    simulation, ///< it did not, or nothing tells and another driver or program welds than then
    unchecked,  ///< the recording names no end, or the repetition is of another length
};

/// `program` and `driver`: of the present run, as records name them.
Repetition repetitionOf(const RecordedAttempt& attempt, const LessonResult& result, const std::string& program,
                        const std::string& driver);

/// "same bits", "simulation of the recording", "not checked".
std::string_view nameOf(Repetition repetition);

/// A sentence or two for people; of a simulation with driver and program of then and now.
std::string repetitionText(const RecordedAttempt& attempt, const LessonResult& result, const std::string& program,
                           const std::string& driver);

} // namespace meltpool
