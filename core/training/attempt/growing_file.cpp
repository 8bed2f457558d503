#include "core/training/attempt/growing_file.hpp"

#include "core/base/error.hpp"
#include "core/base/files.hpp"
#include "core/base/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace meltpool {

namespace fs = std::filesystem;

GrowingFile::GrowingFile(fs::path file) : file_(std::move(file)) {
    stream_ = openFile(file_, "wbx");
    const int code = errno;
    if (stream_ != nullptr) {
        std::setvbuf(stream_, nullptr, _IONBF, 0); // no buffer: append() hands each byte to the system
        return;
    }
    const std::string sentence = std::string("cannot be made: ") + std::strerror(code);
    if (code == ENOSPC || code == EIO || code == EMFILE || code == ENFILE || code == ENOMEM)
        throw RuntimeFault(file_.string() + ": " + sentence + "; " + writeExpectation(code));
    throw InputError(file_, 0, sentence + "; expected a new name in a folder with write permission");
}

GrowingFile::~GrowingFile() {
    if (stream_ != nullptr) std::fclose(stream_);
}

bool GrowingFile::note(bool good) {
    if (good) return true;
    const int code = errno;
    reason_ = std::string(std::strerror(code)) + "; " + writeExpectation(code);
    return false;
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
    const bool synced = note(syncFile(open));
    const bool closed = note(std::fclose(open) == 0);
    return synced && closed;
}

} // namespace meltpool
