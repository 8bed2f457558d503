#include "app/platform/say.hpp"

#include "core/base/text.hpp"

#include <cstdarg>
#include <cstdio>

namespace meltpool {

namespace {

bool quiet = false;
constexpr size_t kMostBytes = 4096; ///< the longest path of Linux

} // namespace

void beQuiet() {
    quiet = true;
}

bool isQuiet() {
    return quiet;
}

void say(const char* format, ...) {
    if (quiet) return;
    va_list values;
    va_start(values, format);
    std::vprintf(format, values);
    va_end(values);
}

void sayResult(const std::string& sentence, const std::filesystem::path& path) {
    const std::string line = quiet ? printable(path.string(), kMostBytes) : sentence;
    if (!line.empty()) std::printf("%s\n", line.c_str());
}

} // namespace meltpool
