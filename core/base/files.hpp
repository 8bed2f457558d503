// What the C library does differently with files on Linux and on Windows.
#pragma once

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace meltpool {

/// fopen(); the mode may have an 'x' for a file that must not be there yet. nullptr and errno where it fails.
std::FILE* openFile(const std::filesystem::path& file, const char* mode);

/// The whole paths of all that lies in a folder, in no order; empty where `failure` says why it cannot be read.
std::vector<std::filesystem::path> listFolder(const std::filesystem::path& folder, std::error_code& failure);

/// Brings what was written to the disk; pipes and some devices have none. False and errno where it fails.
bool syncFile(std::FILE* stream);

/// Whether the stream goes into a pipe, such as that of `| head`: then it is its reader who may end first.
bool isPipe(std::FILE* stream);

/// The number of this process, for names that no other process uses.
long long processNumber();

/// "2026-11-23T08:10:43+0100", in the user's time zone.
std::string isoDate(std::time_t moment);

} // namespace meltpool
