#include "core/training/recording/growing_file.hpp"

#include "core/base/error.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace meltpool {

namespace fs = std::filesystem;

GrowingFile::GrowingFile(fs::path file) : file_(std::move(file)) {
#ifdef _WIN32
    stream_ = _wfopen(file_.c_str(), L"wbx");
#else
    stream_ = std::fopen(file_.c_str(), "wbx");
#endif
    const int code = errno;
    if (stream_ != nullptr) {
        std::setvbuf(stream_, nullptr, _IONBF, 0); // each append() is the system's when it returns
        return;
    }
    const std::string sentence = std::string("cannot be made: ") + std::strerror(code);
    if (code == ENOSPC || code == EIO || code == EMFILE || code == ENFILE || code == ENOMEM)
        throw RuntimeFault(file_.string() + ": " + sentence + "; expected free space");
    throw InputError(file_, 0, sentence + "; expected a new name in a folder with write permission");
}

GrowingFile::~GrowingFile() {
    if (stream_ != nullptr) std::fclose(stream_);
}

bool GrowingFile::note(bool good) {
    if (!good) reason_ = std::strerror(errno);
    return good;
}

bool GrowingFile::append(std::string_view bytes) {
    const size_t count = std::fwrite(bytes.data(), 1, bytes.size(), stream_);
    written_ += count;
    return note(count == bytes.size());
}

void GrowingFile::cut(std::uint64_t bytes) {
    std::error_code failure;
    fs::resize_file(file_, bytes, failure);
    if (!failure) written_ = bytes;
}

void GrowingFile::remove() {
    std::error_code failure;
    fs::remove(file_, failure);
}

bool GrowingFile::there() const {
    std::error_code failure;
    return fs::exists(file_, failure);
}

bool GrowingFile::finish() {
    std::FILE* open = std::exchange(stream_, nullptr);
    if (open == nullptr) return true;
#ifdef _WIN32
    const bool synced = note(_commit(_fileno(open)) == 0);
#else
    const bool synced = note(fsync(fileno(open)) == 0 || errno == EINVAL || errno == EROFS);
#endif
    const bool closed = note(std::fclose(open) == 0);
    return synced && closed;
}

} // namespace meltpool
