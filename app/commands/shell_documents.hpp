// Completion scripts and the manual page, made from the definitions of the command line.
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace meltpool {

/// Script that completes commands, options, files and names of lessons; `shell`: bash, zsh or fish. Throws InputError
/// for another shell.
std::string completionScript(const CLI::App& app, std::string_view shell);

/// Manual page in roff, with the texts of --help.
std::string manualPage(const CLI::App& app);

} // namespace meltpool
