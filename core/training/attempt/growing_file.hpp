// A file that grows at its end and is whole at every moment.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace meltpool {

/// Unlike writeFile(), which gives a file its name when it is whole, this one is there from its first byte on: it is to
/// be found after an end without warning.
class GrowingFile {
  public:
    /// Makes the file. Throws InputError where it is there already or its place cannot be written, and RuntimeFault
    /// where the machine fails.
    explicit GrowingFile(std::filesystem::path file);
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;

    /// Puts bytes behind the last ones, in the system's hands when it returns. False where not all of them could be
    /// written: reason() tells why, and written() how many bytes the file has.
    bool append(std::string_view bytes);
    std::uint64_t written() const { return written_; }
    /// Cuts the file to its first bytes.
    void cut(std::uint64_t bytes);
    /// Takes the file away, as nothing of use came into it.
    void remove();
    /// Whether it still has its name.
    bool there() const;
    /// Brings all to the disk and closes it. False as append() does.
    bool finish();

    const std::filesystem::path& file() const { return file_; }
    /// Why something failed, in the system's words, and what was expected.
    const std::string& reason() const { return reason_; }

  private:
    bool note(bool good);

    std::filesystem::path file_;
    std::FILE* stream_ = nullptr;
    std::uint64_t written_ = 0;
    std::string reason_;
};

} // namespace meltpool
