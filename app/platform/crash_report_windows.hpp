// What the program leaves for its makers when it crashes under Windows.
#pragma once

#include <filesystem>
#include <optional>

namespace meltpool {

/// From now on an unhandled exception, of the processor or of C++, and abort() leave a text crash-DATE-PROCESS.txt with
/// version, driver, lesson and the calls that led there, and a minidump of the same name, in `folder`, which is made
/// then. A line on standard error names the text. Not before main(): it reads the program's version.
void reportCrashes(const std::filesystem::path& folder);

/// Where this process was started by a crashed one: writes the minidump of that and gives the exit code. To be called
/// first of all.
std::optional<int> writeAskedDump();

} // namespace meltpool
