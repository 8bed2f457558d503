#include "core/base/file_lock.hpp"

#include "core/base/error.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#ifdef _WIN32
#include <windows.h>
#else
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace meltpool {

namespace {

[[noreturn]] void failAsHeld(const std::filesystem::path& place) {
    throw InputError(place, 0, "another program is writing here; expected a place of its own, or to wait for its end");
}

#ifndef _WIN32

/// The file may have been removed, or removed and made again, between its opening and its locking.
bool isStillThere(int descriptor, const std::filesystem::path& file) {
    struct stat opened {
    }, named{};
    return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

#endif

} // namespace

#ifdef _WIN32

FileLock::FileLock(const std::filesystem::path& lockFile, const std::filesystem::path& place) : file_(lockFile) {
    handle_ = CreateFileW(lockFile.c_str(), GENERIC_WRITE, 0, nullptr, OPEN_ALWAYS, FILE_FLAG_DELETE_ON_CLOSE, nullptr);
    if (handle_ != INVALID_HANDLE_VALUE) return;
    if (GetLastError() == ERROR_SHARING_VIOLATION) failAsHeld(place);
    throw InputError(place, 0, "cannot be written; expected a folder with write permission");
}

FileLock::~FileLock() {
    CloseHandle(handle_);
}

#else

FileLock::FileLock(const std::filesystem::path& lockFile, const std::filesystem::path& place) : file_(lockFile) {
    for (;;) {
        descriptor_ = open(lockFile.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor_ < 0)
            throw InputError(place, 0,
                             std::string("cannot be written: ") + std::strerror(errno) +
                                 "; expected a folder with write permission");
        if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
            const bool held = errno == EWOULDBLOCK;
            close(descriptor_);
            if (held) failAsHeld(place);
            throw InputError(place, 0, "cannot be locked; expected a folder on a file system with locks");
        }
        if (isStillThere(descriptor_, lockFile)) return;
        close(descriptor_);
    }
}

FileLock::~FileLock() {
    unlink(file_.c_str()); // while it is locked, so that nobody else holds it
    close(descriptor_);
}

#endif

} // namespace meltpool
