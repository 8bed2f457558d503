// Where the system keeps programs, their files and the user's folders.
#pragma once

#include <filesystem>

namespace meltpool {

/// The folder that holds the running program.
std::filesystem::path programFolder();

/// Where the program's own files (shaders, data) lie, seen from its folder.
std::filesystem::path filesOfProgram();

/// The user's folder in which programs keep settings, and the one for what else they keep. Absolute; where the user has
/// no home one in which nothing can be made (Linux).
std::filesystem::path userSettings();
std::filesystem::path userFiles();

/// The user's folder for files of programs that the person makes and that go along to another machine.
std::filesystem::path userDocuments();

/// The user's folder for what programs can make again; empty where the user has no home.
std::filesystem::path userCache();

/// The user's folder for pictures, as the desktop calls it in the user's language; it need not exist. Empty where the
/// user has no home.
std::filesystem::path userPictures();

} // namespace meltpool
