#include "core/base/files.hpp"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <share.h>
#include <sys/stat.h>
#include <windows.h>

namespace meltpool {

namespace {

/// Makes the file; older C libraries of Windows lack the mode 'x'.
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

// Lists by the Windows API: the C library, and with it std::filesystem's iterator, lists no folder whose path is longer
// than 260 characters.
std::vector<std::filesystem::path> listFolder(const std::filesystem::path& folder, std::error_code& failure) {
    failure.clear();
    std::filesystem::path all = std::filesystem::absolute(folder).make_preferred() / L"*";
    if (!all.native().starts_with(L"\\\\")) all = L"\\\\?\\" + all.native(); // others are shares or have the prefix
    std::vector<std::filesystem::path> found;
    WIN32_FIND_DATAW entry;
    const HANDLE search = FindFirstFileW(all.c_str(), &entry);
    bool more = search != INVALID_HANDLE_VALUE;
    while (more) {
        const std::wstring_view name(entry.cFileName);
        if (name != L"." && name != L"..") found.push_back(folder / name);
        more = FindNextFileW(search, &entry) != 0;
    }
    const DWORD ended = GetLastError();
    if (search != INVALID_HANDLE_VALUE) FindClose(search);
    if (ended == ERROR_NO_MORE_FILES) return found;
    failure = std::error_code(static_cast<int>(ended), std::system_category());
    return {};
}

bool syncFile(std::FILE* stream) {
    // Consoles, pipes and NUL have no disk behind them.
    return _commit(_fileno(stream)) == 0 || errno == EBADF || errno == EINVAL;
}

bool isPipe(std::FILE* stream) {
    return GetFileType(reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(stream)))) == FILE_TYPE_PIPE;
}

long long processNumber() {
    return _getpid();
}

std::string isoDate(std::time_t moment) {
    std::tm local{}, world{};
    localtime_s(&local, &moment);
    gmtime_s(&world, &moment);
    // Both count as local winter time: their difference is the zone's offset.
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
