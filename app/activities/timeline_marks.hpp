// The events of an attempt, as marks on its time line.
#pragma once

#include "core/training/judging/judgement.hpp"
#include "core/training/lesson/recorded_attempt.hpp"

#include <string>
#include <vector>

namespace meltpool {

struct TimelineMark {
    double time = 0; ///< s
    std::string text;
    bool fault = false; ///< fault of the hand, the weld or the recording
    bool redo = false;  ///< the attempt went back to here and on to another end
};

/// Marks of the value changes, events and redos of an attempt of `duration` s, in order of time. If the file has no
/// times, its steps count as equally long.
std::vector<TimelineMark> timelineMarks(const RecordedAttempt& attempt, double duration);

/// Marks of a judged attempt's faults that have a place on the seam: corrections at their worst place, and failures of
/// the verdict; each at the time when the arc first burned there.
std::vector<TimelineMark> faultMarks(const Technique& technique, const Judgement& judgement);

} // namespace meltpool
