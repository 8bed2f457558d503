#include "core/base/file_lock.hpp"

#include "core/base/error.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <thread>

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

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLook{10};    ///< pause between two attempts at a held lock
constexpr std::chrono::milliseconds kTurn{3'000}; ///< longest wait; much longer than a small file takes on a slow share

[[noreturn]] void failAsHeld(const std::filesystem::path& place) {
    throw InputError(place, 0,
                     "another program is writing here; expected another place, or a wait until that program ends");
}

#ifndef _WIN32

/// False if the file was removed, or removed and made again, between opening and locking.
bool isStillThere(int descriptor, const std::filesystem::path& file) {
    struct stat opened {
    }, named{};
    return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

#endif

} // namespace

#ifdef _WIN32

FileLock::FileLock(const std::filesystem::path& lockFile, const std::filesystem::path& place,
                   std::chrono::milliseconds patience)
    : file_(lockFile) {
    for (const Clock::time_point until = Clock::now() + patience;;) {
        handle_ =
            CreateFileW(lockFile.c_str(), GENERIC_WRITE, 0, nullptr, OPEN_ALWAYS, FILE_FLAG_DELETE_ON_CLOSE, nullptr);
        if (handle_ != INVALID_HANDLE_VALUE) return;
        const DWORD code = GetLastError();
        // Windows reports a file that is being deleted as one without permission.
        const bool held = code == ERROR_SHARING_VIOLATION || code == ERROR_ACCESS_DENIED;
        if (!held || Clock::now() >= until) {
            if (code == ERROR_SHARING_VIOLATION) failAsHeld(place);
            throw InputError(place, 0, "cannot be written; expected a folder with write permission");
        }
        std::this_thread::sleep_for(kLook);
    }
}

FileLock::~FileLock() {
    CloseHandle(handle_);
}

#else

FileLock::FileLock(const std::filesystem::path& lockFile, const std::filesystem::path& place,
                   std::chrono::milliseconds patience)
    : file_(lockFile) {
    for (const Clock::time_point until = Clock::now() + patience;;) {
        descriptor_ = open(lockFile.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor_ < 0)
            throw InputError(place, 0,
                             std::string("cannot be written: ") + std::strerror(errno) +
                                 "; expected a folder with write permission");
        const int code = flock(descriptor_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
        if (code == 0 && isStillThere(descriptor_, lockFile)) return;
        const bool held = code == EWOULDBLOCK || code == EACCES; // some shares report the second code
        if (code != 0 && code != EINTR && !held) {
            warning_ = place.string() + ": cannot be locked (" + std::strerror(code) +
                       "), so that two programs that write here at the same time would mix their files.";
            return;
        }
        close(descriptor_);
        if (held && Clock::now() >= until) failAsHeld(place);
        if (held) std::this_thread::sleep_for(kLook);
    }
}

FileLock::~FileLock() {
    unlink(file_.c_str()); // removed while it is locked, so that no other process holds it
    close(descriptor_);
}

#endif

namespace {

std::filesystem::path lockBeside(const std::filesystem::path& file) {
    std::error_code failed; // the lock below reports a folder that cannot be made
    std::filesystem::create_directories(file.parent_path(), failed);
    std::filesystem::path lock = file;
    return lock += ".lock";
}

} // namespace

FileTurn::FileTurn(const std::filesystem::path& file) : lock_(lockBeside(file), file, kTurn) {}

} // namespace meltpool
