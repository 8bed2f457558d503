// The moments that a kept attempt's recording holds, where they may be used here.
#pragma once

#include "app/activities/replay_end.hpp"
#include "core/training/attempt/recorded_moments.hpp"
#include "core/training/lesson/lesson.hpp"

#include <memory>
#include <string>

namespace meltpool {

struct MomentsOfAttempt {
    std::unique_ptr<RecordedMoments> moments; ///< null: there are none, or none to be used
    std::string refused;                      ///< why those that there are may not be used, as a sentence; else empty
};

/// Of the attempt that takeTorch() gave the lesson. A moment made by another program or driver, or in another version
/// of the lesson, may have other bits than the steps to it have here: it is not used. Throws InputError where the file
/// is no sound recording any more.
MomentsOfAttempt momentsOfAttempt(const Lesson& lesson, const ReplayMachine& machine);

} // namespace meltpool
