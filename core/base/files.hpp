// File functions that differ between the C libraries of Linux and Windows.
#pragma once

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace meltpool {

/// Calls fopen(); the mode 'x' refuses an existing file. Returns nullptr and sets errno on failure.
std::FILE* openFile(const std::filesystem::path& file, const char* mode);

/// The full paths of a folder's entries, unordered; empty if `failure` says why it cannot be read.
std::vector<std::filesystem::path> listFolder(const std::filesystem::path& folder, std::error_code& failure);

/// Flushes written data to the disk; no-op for pipes and some devices. Returns false and sets errno on failure.
bool syncFile(std::FILE* stream);

/// True for a pipe, such as that of `| head`: its reader may end first.
bool isPipe(std::FILE* stream);

/// The process number, for names that no other process uses.
long long processNumber();

/// "2026-11-23T08:10:43+0100", in the user's time zone.
std::string isoDate(std::time_t moment);

} // namespace meltpool
