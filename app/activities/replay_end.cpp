#include "app/activities/replay_end.hpp"

#include "app/platform/program_info.hpp"
#include "core/base/words.hpp"
#include "core/gl/gl.hpp"

namespace meltpool {

namespace {

/// Text of a machine: "version 0.1.0 (1a2b3c4) on GeForce RTX 3060"; parts missing in a record are called unknown.
std::string machineText(const std::string& program, const std::string& driver) {
    if (program.empty() && driver.empty()) return phrase("attempt.machine.unknown");
    if (program.empty()) return phrase("attempt.machine.driver", {{"driver", driver}});
    if (driver.empty()) return phrase("attempt.machine.program", {{"program", program}});
    return phrase("attempt.machine.both", {{"program", program}, {"driver", driver}});
}

} // namespace

ReplayMachine thisMachine() {
    const GLubyte* driver = glGetString(GL_RENDERER);
    return {programBuild(), driver == nullptr ? std::string() : reinterpret_cast<const char*>(driver)};
}

ReplayEnd replayEnd(const RecordedAttempt* attempt, size_t steps, std::uint64_t stateHash,
                    const ReplayMachine& machine) {
    using Answer = ReplayEnd::Verdict;
    if (attempt == nullptr) return {Answer::unknown, phrase("attempt.end.path")};
    if (attempt->stateHash.empty()) return {Answer::unknown, phrase("attempt.end.broken_off")};
    const auto same = sameEnd(*attempt, steps, stateHash);
    if (!same) return {Answer::unknown, phrase("attempt.end.other_step")};
    if (*same) return {Answer::same, phrase("attempt.end.same")};
    return {Answer::different,
            phrase("attempt.end.different", {{"recorder", machineText(attempt->head.program, attempt->head.driver)},
                                             {"player", machineText(machine.program, machine.driver)}})};
}

} // namespace meltpool
