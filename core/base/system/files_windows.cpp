#include "core/base/system/files.hpp"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <share.h>
#include <sys/stat.h>

namespace meltpool {

namespace {

/// Older C libraries of Windows do not know the mode's 'x'.
std::FILE* makeNewFile(const std::filesystem::path& file) {
    int descriptor = -1;
    const errno_t code = _wsopen_s(&descriptor, file.c_str(), _O_CREAT | _O_EXCL | _O_BINARY | _O_WRONLY | _O_NOINHERIT,
                                   _SH_DENYNO, _S_IREAD | _S_IWRITE);
    if (code != 0) {
        errno = code;
        return nullptr;
    }
    return _fdopen(descriptor, "wb");
}

} // namespace

std::FILE* openFile(const std::filesystem::path& file, const char* mode) {
    if (std::strchr(mode, 'x') != nullptr) return makeNewFile(file);
    return _wfopen(file.c_str(), std::wstring(mode, mode + std::strlen(mode)).c_str());
}

bool syncFile(std::FILE* stream) {
    // Consoles, pipes and NUL have no disk behind them.
    return _commit(_fileno(stream)) == 0 || errno == EBADF || errno == EINVAL;
}

long long processNumber() {
    return _getpid();
}

std::string isoDate(std::time_t moment) {
    std::tm local{}, world{};
    localtime_s(&local, &moment);
    gmtime_s(&world, &moment);
    // Both as if they were local time in winter: their difference is the zone's offset.
    local.tm_isdst = world.tm_isdst = 0;
    std::tm localCopy = local;
    const long minutes = static_cast<long>(std::difftime(std::mktime(&localCopy), std::mktime(&world)) / 60);
    std::array<char, 32> text{}, zone{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &local);
    const long size = minutes < 0 ? -minutes : minutes;
    std::snprintf(zone.data(), zone.size(), "%c%02ld%02ld", minutes < 0 ? '-' : '+', size / 60, size % 60);
    return std::string(text.data()) + zone.data();
}

} // namespace meltpool
