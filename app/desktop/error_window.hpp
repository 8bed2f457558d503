// Shows in a window why the program ended, for people who started it without a terminal.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// Shows the sentence until the person closes it: in a window of the X display, which needs no OpenGL, else by the
/// desktop's own dialog program. False where there is neither.
bool showErrorWindow(const std::string& sentence);

/// A dialog program and its words.
struct DialogCommand {
    std::string program; ///< name in PATH
    std::vector<std::string> words;
};

/// The dialog programs to be tried in this order. `desktop`: the variable XDG_CURRENT_DESKTOP.
std::vector<DialogCommand> dialogCommands(const std::string& sentence, const std::string& desktop);

} // namespace meltpool
