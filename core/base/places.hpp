// The system's folders: the program, its files and the user's folders.
#pragma once

#include <filesystem>

namespace meltpool {

/// The folder that holds the running program.
std::filesystem::path programFolder();

/// The folder of the program's own files (shaders, data), relative to the program's folder.
std::filesystem::path filesOfProgram();

/// The user's folder for settings, and the one for other data of programs. Absolute; for a user without a home a path
/// in which nothing can be made (Linux).
std::filesystem::path userSettings();
std::filesystem::path userFiles();

/// The user's folder for program files that the user makes and takes along to another machine.
std::filesystem::path userDocuments();

/// The user's folder for files that programs can make again; empty if the user has no home.
std::filesystem::path userCache();

/// The user's folder for pictures, with the desktop's name in the user's language; it may not exist. Empty if the user
/// has no home.
std::filesystem::path userPictures();

} // namespace meltpool
