// The declared command line in the form that completion scripts and the manual page need.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace meltpool {

/// Kind of an option's value on the command line.
enum class ValueKind {
    none,    ///< a flag, which takes no value
    free,    ///< a number or a text that cannot be completed
    file,    ///< any file
    folder,  ///< a folder
    lesson,  ///< a lesson's name, or its file
    setting, ///< KEY=VALUE of the lesson that the command line names
    suite,   ///< a suite of the benchmark
    shell,   ///< a shell that has a completion script
};

/// Option or positional argument.
struct DeclaredWord {
    std::string name;  ///< "--out"; "LESSON" of a positional argument
    std::string value; ///< name of its value, "DIR"; empty for a flag
    std::string text;  ///< text in --help; may have several lines
    ValueKind kind = ValueKind::none;
    bool repeated = false; ///< true: may be repeated, or takes several values
    bool required = false;
};

struct DeclaredCommand {
    std::string name; ///< "run"; empty for the program itself
    std::string text;
    std::vector<DeclaredWord> options, positionals;
};

/// The program itself first, then its commands, without hidden commands and options.
std::vector<DeclaredCommand> declaredCommands(const CLI::App& app);

} // namespace meltpool
