#include "app/activities/replay_end.hpp"

#include "app/platform/program_info.hpp"
#include "core/gl/gl.hpp"

namespace meltpool {

namespace {

/// "version 0.1.0 (1a2b3c4) on GeForce RTX 3060"; what a record does not tell is said to be unknown.
std::string machineText(const std::string& program, const std::string& driver) {
    return (program.empty() ? std::string("an unknown version") : "version " + program) + " on " +
           (driver.empty() ? std::string("an unknown driver") : driver);
}

} // namespace

ReplayMachine thisMachine() {
    const GLubyte* driver = glGetString(GL_RENDERER);
    return {programBuild(), driver == nullptr ? std::string() : reinterpret_cast<const char*>(driver)};
}

ReplayEnd replayEnd(const RecordedAttempt* attempt, size_t steps, std::uint64_t stateHash,
                    const ReplayMachine& machine) {
    using Verdict = ReplayEnd::Verdict;
    if (attempt == nullptr) return {Verdict::unknown, "A torch path has no state to compare this one with."};
    if (attempt->stateHash.empty())
        return {Verdict::unknown, "The recording broke off without the state of its metal: nothing to compare with."};
    const auto same = sameEnd(*attempt, steps, stateHash);
    if (!same) return {Verdict::unknown, "The recording's state is that of another step than the last one played."};
    if (*same) return {Verdict::same, "The metal is that of the attempt, to the last bit."};
    return {Verdict::different, "This is a simulation of the recording: the metal is not that of the attempt to the "
                                "last bit. Recorded by " +
                                    machineText(attempt->head.program, attempt->head.driver) + ", played by " +
                                    machineText(machine.program, machine.driver) + "."};
}

} // namespace meltpool
