// A file that grows at its end and is valid at every moment.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// writeFile() gives a file its name when it is whole; this one has its name from its first byte on, so that it can be
/// found after the program ended without warning.
class GrowingFile {
  public:
    /// Creates the file. Throws InputError if it exists already or its place cannot be written, and RuntimeFault if the
    /// machine fails.
    explicit GrowingFile(std::filesystem::path file);
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;

    /// Appends bytes and hands them to the system before it returns. False if not all of them could be written: see
    /// reason(); written() is the file's size in bytes.
    bool append(std::string_view bytes);
    std::uint64_t written() const { return written_; }
    /// Cuts the file to its first `bytes` bytes.
    void cut(std::uint64_t bytes);
    /// Deletes the file, if nothing of use came into it.
    void remove();
    /// True while the file has its name.
    bool there() const;
    /// Flushes everything to the disk and closes the file. False as for append().
    bool finish();

    const std::filesystem::path& file() const { return file_; }
    /// Reason of a failure, in the system's words, and what was expected.
    const std::string& reason() const { return reason_; }

  private:
    bool note(bool good);

    std::filesystem::path file_;
    std::FILE* stream_ = nullptr;
    std::uint64_t written_ = 0;
    std::string reason_;
};

} // namespace meltpool
