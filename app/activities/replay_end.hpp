// The result of comparing a replay with the bits of its recording, and its sentences.
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

/// Machine that plays: version and commit of the program, name of the graphics driver.
struct ReplayMachine {
    std::string program;
    std::string driver;
};

/// Returns the running machine; its graphics must be connected.
ReplayMachine thisMachine();

/// Compares the end of a replay. `attempt`: null for a plain torch path. `steps`, `stateHash`: of the replay's last
/// step.
ReplayEnd replayEnd(const RecordedAttempt* attempt, size_t steps, std::uint64_t stateHash,
                    const ReplayMachine& machine);

} // namespace meltpool
