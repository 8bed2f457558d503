// Writes whole files so that nobody ever finds a part of one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// Writes `bytes` as the whole of `file`: under a temporary name beside it, checked at every write, brought to the
/// disk, then renamed. A crash or a full disk leaves the old file or the new one, never a part, and no temporary file
/// is left but by a crash. A symbolic link keeps pointing where it did, and the file keeps its permissions. Devices and
/// pipes are written directly. Throws InputError where the place cannot be written at all, and RuntimeFault where the
/// machine fails while it is written, as a full disk does.
void writeFile(const std::filesystem::path& file, std::string_view bytes);

/// Throws what writeFile() would throw at once, without changing anything. A full disk is not found out.
void requireWritable(const std::filesystem::path& file);

/// What was expected of the machine where writing failed with this errno, for the end of a sentence: "expected free
/// space" of a full disk only.
std::string writeExpectation(int code);

/// Whether `file` is, or would be made as, a regular file: no device, pipe or folder.
bool isPlainFile(const std::filesystem::path& file);

} // namespace meltpool
