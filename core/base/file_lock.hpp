// Keeps two programs from writing into the same place at the same time.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace meltpool {

/// Excludes all other holders of a lock on the same file, in this process and in others. The system releases the lock
/// with the process, however that ends; the empty lock file that a killed process leaves locks nothing.
class FileLock {
  public:
    /// Makes `lockFile` and locks it; the destructor removes it. `place`: the file or folder that is written, for
    /// messages. Waits up to `patience` while another process holds it. Throws InputError if that process is still
    /// writing afterwards, or if the file cannot be made. A file system without locks (some network shares) is no
    /// error: see warning().
    FileLock(const std::filesystem::path& lockFile, const std::filesystem::path& place,
             std::chrono::milliseconds patience = {});
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// A sentence for the user if the file system has no locks, so that nothing is locked; else empty.
    const std::string& warning() const { return warning_; }

  private:
    std::filesystem::path file_;
    std::string warning_;
#ifdef _WIN32
    void* handle_ = nullptr;
#else
    int descriptor_ = -1;
#endif
};

/// The lock around reading, changing and writing one of the user's files: several programs, also on several machines,
/// may share a home. Waits a few seconds for its turn. Makes the file's folder. Throws as FileLock.
class FileTurn {
  public:
    explicit FileTurn(const std::filesystem::path& file);

    /// See FileLock::warning().
    const std::string& warning() const { return lock_.warning(); }

  private:
    FileLock lock_;
};

} // namespace meltpool
