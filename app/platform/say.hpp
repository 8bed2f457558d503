// What a command says on standard output beside its result; --quiet leaves it out.
#pragma once

#include <filesystem>
#include <string>

namespace meltpool {

/// From now on only sayResult() says something: the path.
void beQuiet();
bool isQuiet();

/// A sentence, as std::printf() formats it.
#if defined(__GNUC__)
[[gnu::format(printf, 1, 2)]]
#endif
void say(const char* format, ...);

/// Where the result of the command is: `sentence`, or the path alone where the program is quiet; each on a line.
void sayResult(const std::string& sentence, const std::filesystem::path& path);

} // namespace meltpool
