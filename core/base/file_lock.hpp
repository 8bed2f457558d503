// Keeps two programs from writing into the same place at the same time.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace meltpool {

/// While it lives nobody else, in this process or another, can hold the lock of the same file. The system gives it up
/// with the process, however that ends; the empty lock file that a killed process leaves does not lock anything.
class FileLock {
  public:
    /// Makes `lockFile` and locks it; it is removed at the end. `place`: the file or folder that is written, for
    /// messages. Waits up to `patience` while another holds it. Throws InputError when another still writes there, or
    /// when the file cannot be made. A file system without locks (a share of the network may have none) is no error:
    /// see warning().
    FileLock(const std::filesystem::path& lockFile, const std::filesystem::path& place,
             std::chrono::milliseconds patience = {});
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// A sentence for the person where the file system has no locks, so that nothing is locked; else empty.
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

/// Who reads a file of the person's, changes it and writes it holds this meanwhile: several programs, on several
/// machines too, may have the same home. Waits a few seconds for its turn. Makes the file's folder. Throws as FileLock.
class FileTurn {
  public:
    explicit FileTurn(const std::filesystem::path& file);

    /// See FileLock::warning().
    const std::string& warning() const { return lock_.warning(); }

  private:
    FileLock lock_;
};

} // namespace meltpool
