// Folders of the program's own files (shaders, data) and of the user's settings.
#pragma once

#include "core/base/places.hpp"

#include <filesystem>

namespace meltpool {

/// The folder with `shaders/` and `data/`: $MELTPOOL_DATA if set, else ../share/meltpool relative to the program's
/// folder, or under Windows that folder itself. Throws InputError if there is no such folder.
std::filesystem::path resourceFolder();

/// The user's settings folder for this program ($XDG_CONFIG_HOME/meltpool, ~/.config/meltpool, %APPDATA%/meltpool).
/// Does not create it.
std::filesystem::path settingsFolder();

/// The user's folder for this program's stored data ($XDG_DATA_HOME/meltpool, ~/.local/share/meltpool,
/// %LOCALAPPDATA%/meltpool). Does not create it.
std::filesystem::path keptFolder();

/// The user's folder for files that the user makes for this program and takes along ($XDG_DATA_HOME/meltpool,
/// ~/.local/share/meltpool, %APPDATA%/meltpool). Does not create it.
std::filesystem::path ownFilesFolder();

/// The user's folder for files that this program can make again ($XDG_CACHE_HOME/meltpool, ~/.cache/meltpool,
/// %LOCALAPPDATA%/meltpool); empty if the user has no home. Does not create it.
std::filesystem::path cacheFolder();

} // namespace meltpool
