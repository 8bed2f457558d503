// Whether a replay came to the bits of its recording, and what is told of it.
#pragma once

#include "core/training/lesson/recorded_attempt.hpp"

#include <cstdint>
#include <string>

namespace meltpool {

struct ReplayEnd {
    enum class Verdict { same, different, unknown };
    Verdict verdict = Verdict::unknown;
    std::string text; ///< a sentence or two
};

/// What plays: version and commit of the program, name of the graphics driver.
struct ReplayMachine {
    std::string program;
    std::string driver;
};

/// The one that runs; its graphics must be connected.
ReplayMachine thisMachine();

/// `attempt`: null for a plain torch path. `steps`, `stateHash`: where the replay ended.
ReplayEnd replayEnd(const RecordedAttempt* attempt, size_t steps, std::uint64_t stateHash,
                    const ReplayMachine& machine);

} // namespace meltpool
