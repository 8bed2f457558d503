// The report for the makers when the program crashes on Windows.
#pragma once

#include <filesystem>
#include <optional>

namespace meltpool {

/// Makes an unhandled exception, of the processor or of C++, and abort() write a text crash-DATE-PROCESS.txt with
/// version, driver, lesson and the calls that led there, and a minidump of that name, to `folder`, which is created
/// then. A line on standard error names the text. Not before main(): it reads the program's version.
void reportCrashes(const std::filesystem::path& folder);

/// Writes the minidump if a crashed process started this one, and returns the exit code. Call it first of all.
std::optional<int> writeAskedDump();

} // namespace meltpool
