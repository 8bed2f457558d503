// The declared command line as completion scripts and the manual page need it.
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
    suite,   ///< a part of the benchmark
    shell,   ///< a shell that has a completion script
};

/// An option or a positional argument.
struct DeclaredWord {
    std::string name;  ///< "--out"; of a positional argument "LESSON"
    std::string value; ///< name of its value, "DIR"; empty of a flag
    std::string text;  ///< of --help; may have several lines
    ValueKind kind = ValueKind::none;
    bool repeated = false; ///< may be given again, or takes several values
    bool required = false;
};

struct DeclaredCommand {
    std::string name; ///< "run"; of the program itself empty
    std::string text;
    std::vector<DeclaredWord> options, positionals;
};

/// The program itself first, then its commands, without hidden commands and options.
std::vector<DeclaredCommand> declaredCommands(const CLI::App& app);

} // namespace meltpool
