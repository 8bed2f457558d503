// The messages of a command on standard output; --quiet leaves out all but the result.
#pragma once

#include <filesystem>
#include <string>

namespace meltpool {

/// Silences everything but the path in sayResult().
void beQuiet();
bool isQuiet();

/// Prints a sentence, as std::printf() formats it.
#if defined(__GNUC__)
[[gnu::format(printf, 1, 2)]]
#endif
void say(const char* format, ...);

/// Prints the place of the command's result: `sentence`, or only the path if the program is quiet; each on a line.
void sayResult(const std::string& sentence, const std::filesystem::path& path);

} // namespace meltpool
