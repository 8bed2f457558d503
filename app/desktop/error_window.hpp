// Shows why the program ended in a window, for people who started it without a terminal.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// Shows the sentence until the person closes it: in a window of the X display, which needs no OpenGL, else by the
/// desktop's own dialog program. Returns false if there is neither.
bool showErrorWindow(const std::string& sentence);

/// Command line of a dialog program.
struct DialogCommand {
    std::string program; ///< name in PATH
    std::vector<std::string> words;
};

/// Returns the dialog programs in the order of trial. `desktop`: the variable XDG_CURRENT_DESKTOP.
std::vector<DialogCommand> dialogCommands(const std::string& sentence, const std::string& desktop);

} // namespace meltpool
