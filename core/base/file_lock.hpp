// Keeps two programs from writing into the same place at the same time.
#pragma once

#include <filesystem>

namespace meltpool {

/// While it lives nobody else, in this process or another, can hold the lock of the same file. The system gives it up
/// with the process, however that ends; the empty lock file that a killed process leaves does not lock anything.
class FileLock {
  public:
    /// Makes `lockFile` and locks it; it is removed at the end. `place`: what is written, for messages. Throws
    /// InputError when somebody else writes there, or when the file cannot be made.
    FileLock(const std::filesystem::path& lockFile, const std::filesystem::path& place);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    std::filesystem::path file_;
#ifdef _WIN32
    void* handle_ = nullptr;
#else
    int descriptor_ = -1;
#endif
};

} // namespace meltpool
