#include "core/base/files.hpp"

#include <array>
#include <cerrno>

#include <sys/stat.h>
#include <unistd.h>

namespace meltpool {

std::FILE* openFile(const std::filesystem::path& file, const char* mode) {
    return std::fopen(file.c_str(), mode);
}

std::vector<std::filesystem::path> listFolder(const std::filesystem::path& folder, std::error_code& failure) {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder, failure))
        found.push_back(entry.path());
    return found;
}

bool syncFile(std::FILE* stream) {
    return fsync(fileno(stream)) == 0 || errno == EINVAL || errno == EROFS;
}

bool isPipe(std::FILE* stream) {
    struct stat kind {};
    return fstat(fileno(stream), &kind) == 0 && (S_ISFIFO(kind.st_mode) || S_ISSOCK(kind.st_mode));
}

long long processNumber() {
    return getpid();
}

std::string isoDate(std::time_t moment) {
    std::tm parts{};
    localtime_r(&moment, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S%z", &parts);
    return text.data();
}

} // namespace meltpool
