// What happened in an attempt, as marks on its time line.
#pragma once

#include "core/training/judging/judgement.hpp"
#include "core/training/lesson/recorded_attempt.hpp"

#include <string>
#include <vector>

namespace meltpool {

struct TimelineMark {
    double time = 0; ///< s
    std::string text;
    bool fault = false; ///< of the hand, the weld or the recording
    bool redo = false;  ///< the attempt went back to here and on to another end
};

/// The changes of values, the events and the redos of an attempt of `duration` s, in the order of their times. Where
/// the file does not tell a moment its steps are taken to be of even length.
std::vector<TimelineMark> timelineMarks(const RecordedAttempt& attempt, double duration);

/// What is at fault of an attempt that was judged, where it has a place on the seam: what to correct, at its worst, and
/// what the verdict fails; each at the moment when the arc first burned there.
std::vector<TimelineMark> faultMarks(const Technique& technique, const Judgement& judgement);

} // namespace meltpool
