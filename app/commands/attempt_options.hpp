// The command line of the commands for attempts: replay, compare, demonstration.
#pragma once

#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace meltpool {

struct AttemptArguments {
    ReplayRequest replay;
    CompareRequest compare;
    DemonstrationRequest demonstration;
    bool noPage = false;
};

/// Adds the commands, which write their values into `arguments`.
void addAttemptCommands(CLI::App& app, AttemptArguments& arguments);

/// Runs the one of them that was given. Returns false if none was.
bool runAttemptCommand(const CLI::App& app, const AttemptArguments& arguments);

} // namespace meltpool
