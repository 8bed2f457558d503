// Writes whole files: a reader never finds a part of one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// Writes `bytes` as the whole of `file`: under a temporary name in its folder, checked at every write, flushed to the
/// disk, then renamed. A crash or a full disk leaves the old file or the new one, never a part; only a crash leaves a
/// temporary file. A symbolic link keeps its target, and the file its permissions. Devices and pipes are written
/// directly. Throws InputError if the place cannot be written at all, and RuntimeFault if the machine fails during the
/// writing, for example with a full disk.
void writeFile(const std::filesystem::path& file, std::string_view bytes);

/// Throws the exceptions that writeFile() would throw at once, without changing anything. Does not detect a full disk.
void requireWritable(const std::filesystem::path& file);

/// The expectation for the end of a sentence after writing failed with this errno: "expected free space" only for a
/// full disk.
std::string writeExpectation(int code);

/// True if `file` is a regular file or would be made as one: no device, pipe or folder.
bool isPlainFile(const std::filesystem::path& file);

} // namespace meltpool
