// The checkpoints in a stored attempt's recording, if they can be used here.
#pragma once

#include "app/activities/replay_end.hpp"
#include "core/training/attempt/recorded_checkpoints.hpp"
#include "core/training/lesson/lesson.hpp"

#include <memory>
#include <string>

namespace meltpool {

struct FileCheckpoints {
    std::unique_ptr<RecordedCheckpoints> moments; ///< null: there are none, or none to use
    std::string refused; ///< sentence that says why existing checkpoints must not be used; else empty
};

/// Checkpoints of the attempt whose torch takeTorch() set in the lesson. One made by another program or driver, or in
/// another version of the lesson, may have other bits than the steps to it give here: it is not used. Throws InputError
/// when the file is no sound recording any more.
FileCheckpoints fileCheckpoints(const Lesson& lesson, const ReplayMachine& machine);

} // namespace meltpool
