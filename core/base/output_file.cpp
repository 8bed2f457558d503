#include "core/base/output_file.hpp"

#include "core/base/error.hpp"
#include "core/base/files.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

constexpr int kMostLinks = 32; ///< a longer chain of symbolic links is a circle

/// True for failures of disk or system; all other failures come from the choice of the place.
bool isMachineFault(int code) {
    return code == ENOSPC || code == EIO || code == EMFILE || code == ENFILE || code == ENOMEM
#ifdef EDQUOT
           || code == EDQUOT
#endif
        ;
}

[[noreturn]] void failToOpen(const fs::path& file, int code) {
    const std::string reason = std::string("cannot be written: ") + std::strerror(code);
    if (isMachineFault(code)) throw RuntimeFault(file.string() + ": " + reason + "; " + writeExpectation(code));
    throw InputError(file, 0, reason + "; expected a folder with write permission");
}

/// A file for writing that closes itself.
class Stream {
  public:
    Stream(const fs::path& file, const char* mode) {
        stream_ = openFile(file, mode);
        code_ = stream_ == nullptr ? errno : 0;
        if (stream_ != nullptr) std::setvbuf(stream_, nullptr, _IONBF, 0);
    }
    ~Stream() { close(); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    bool open() const { return stream_ != nullptr; }
    /// The errno of the failed opening or of the last failure; 0: none.
    int code() const { return code_; }

    bool write(std::string_view bytes) {
        return note(std::fwrite(bytes.data(), 1, bytes.size(), stream_) == bytes.size());
    }
    /// Flushes to the disk; no-op for pipes and some devices.
    bool sync() { return note(syncFile(stream_)); }
    bool close() {
        std::FILE* open = std::exchange(stream_, nullptr);
        return open == nullptr || note(std::fclose(open) == 0);
    }

  private:
    bool note(bool good) {
        if (!good) code_ = errno;
        return good;
    }

    std::FILE* stream_ = nullptr;
    int code_ = 0;
};

/// The end of a chain of symbolic links; the renamed file must replace that file, not the link.
fs::path endOfLinks(fs::path file) {
    std::error_code unreadable;
    for (int i = 0; i < kMostLinks && fs::is_symlink(file, unreadable); ++i) {
        const fs::path next = fs::read_symlink(file, unreadable);
        if (unreadable) break;
        file = next.is_absolute() ? next : file.parent_path() / next;
    }
    return file;
}

/// A name in the folder of `file` that no other process uses.
fs::path draftName(const fs::path& file) {
    fs::path name = file;
    name += "." + std::to_string(processNumber()) + ".tmp";
    return name;
}

[[noreturn]] void failToWrite(const fs::path& file, int code) {
    throw RuntimeFault(file.string() + ": cannot be written to its end: " + std::strerror(code) + "; " +
                       writeExpectation(code));
}

void writeDirectly(const fs::path& file, std::string_view bytes) {
    Stream stream(file, "wb");
    if (!stream.open()) failToOpen(file, stream.code());
    const bool written = stream.write(bytes) && stream.sync();
    if (!stream.close() || !written) failToWrite(file, stream.code());
}

/// Throws if an existing file must not be changed, which renaming would not notice.
void requirePermission(const fs::path& file) {
    std::error_code unreadable;
    if (!fs::exists(file, unreadable)) return;
    const Stream stream(file, "r+b");
    if (!stream.open()) failToOpen(file, stream.code());
}

void requireNoFolder(const fs::path& file) {
    std::error_code unreadable;
    if (fs::is_directory(file, unreadable)) throw InputError(file, 0, "this is a folder; expected the name of a file");
}

/// Removes the temporary file unless it was renamed.
struct Draft {
    fs::path name;
    bool renamed = false;
    ~Draft() {
        std::error_code ignored;
        if (!renamed) fs::remove(name, ignored);
    }
};

} // namespace

std::string writeExpectation(int code) {
    switch (code) {
    case ENOSPC:
    case EFBIG:
#ifdef EDQUOT
    case EDQUOT:
#endif
        return "expected free space";
    case EIO:
        return "expected a working disk or share";
    case EMFILE:
    case ENFILE:
        return "expected fewer open files";
    case ENOMEM:
        return "expected free memory";
    default:
        return "expected a place that takes the whole file";
    }
}

bool isPlainFile(const fs::path& file) {
    std::error_code unreadable;
    const fs::file_status status = fs::status(file, unreadable);
    return fs::is_regular_file(status) || !fs::exists(status);
}

void writeFile(const fs::path& file, std::string_view bytes) {
    requireNoFolder(file);
    if (!isPlainFile(file)) return writeDirectly(file, bytes);
    const fs::path target = endOfLinks(file);
    requirePermission(target);
    std::error_code failure;
    Draft draft{draftName(target)};
    fs::remove(draft.name, failure); // left by a crash of a process with the same number
    Stream stream(draft.name, "wbx");
    if (!stream.open()) failToOpen(file, stream.code());
    const fs::file_status before = fs::status(target, failure);
    if (fs::exists(before)) fs::permissions(draft.name, before.permissions(), failure);
    const bool written = stream.write(bytes) && stream.sync();
    if (!stream.close() || !written) failToWrite(file, stream.code());
    fs::rename(draft.name, target, failure);
    if (failure) throw RuntimeFault(file.string() + ": the finished file cannot be renamed: " + failure.message());
    draft.renamed = true;
}

void requireWritable(const fs::path& file) {
    requireNoFolder(file);
    if (!isPlainFile(file)) return; // opening a pipe would wait for its reader
    const fs::path target = endOfLinks(file);
    requirePermission(target);
    std::error_code failure;
    const Draft draft{draftName(target)};
    fs::remove(draft.name, failure);
    const Stream stream(draft.name, "wbx");
    if (!stream.open()) failToOpen(file, stream.code());
}

} // namespace meltpool
