// Where the program's own files are (shaders, data), found relative to the program so that it runs from anywhere.
#pragma once

#include <filesystem>

namespace meltpool {

/// The folder that holds the running program.
std::filesystem::path programFolder();

/// The folder with `shaders/` and `data/`: $MELTPOOL_DATA where set, else ../share/meltpool beside the program's
/// folder. Throws InputError when it is not there.
std::filesystem::path resourceFolder();

/// The user's own settings folder for this program ($XDG_CONFIG_HOME/meltpool, ~/.config/meltpool, %APPDATA%/meltpool).
/// Not created here.
std::filesystem::path settingsFolder();

} // namespace meltpool
