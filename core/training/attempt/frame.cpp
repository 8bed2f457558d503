#include "core/training/attempt/frame.hpp"

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/training/attempt/little_endian.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace meltpool {

namespace fs = std::filesystem;

std::uint32_t FrameChain::addHead(std::uint32_t kind, std::uint32_t length) {
    std::array<char, 8> bytes{};
    ByteWriter writer(bytes.data());
    writer.u32(kind);
    writer.u32(length);
    add({bytes.data(), bytes.size()});
    return static_cast<std::uint32_t>(hash_.value());
}

std::uint64_t FrameChain::addContent(std::string_view content) {
    add(content);
    return hash_.value();
}

void appendFrame(std::string& file, FrameChain& chain, std::uint32_t kind, std::string_view content) {
    const auto length = static_cast<std::uint32_t>(content.size());
    std::array<char, kFrameHeadBytes> head{};
    ByteWriter writer(head.data());
    writer.u32(kind);
    writer.u32(length);
    writer.u32(chain.addHead(kind, length));
    file.append(head.data(), head.size());
    file.append(content);
    std::array<char, sizeof(std::uint64_t)> hash{};
    ByteWriter(hash.data()).u64(chain.addContent(content));
    file.append(hash.data(), hash.size());
}

FrameReader::FrameReader(const fs::path& file) {
    std::error_code unreadable;
    if (!isPlainFile(file)) throw InputError(file, 0, "is not a file; expected a recording");
    size_ = fs::file_size(file, unreadable);
    stream_.open(file, std::ios::binary);
    if (unreadable || !stream_) throw InputError(file, 0, "cannot be read; expected a recording");
    std::string begin;
    const std::uint64_t there = std::min<std::uint64_t>(size_, kRecordingSignature.size());
    if (!take(begin, there)) throw InputError(file, 0, "cannot be read to its end; expected a recording");
    if (!kRecordingSignature.starts_with(begin))
        throw InputError(file, 0,
                         "does not begin like a recording (first 8 bytes); expected a recording of this program");
    offset_ = there;
    if (there < kRecordingSignature.size()) ended_ = Ended::cut;
}

bool FrameReader::take(std::string& bytes, std::uint64_t count) {
    bytes.resize(count);
    stream_.read(bytes.data(), static_cast<std::streamsize>(count));
    return stream_.gcount() == static_cast<std::streamsize>(count);
}

bool FrameReader::next(RecordingFrame& frame) {
    if (ended_ != Ended::not_) return false;
    const std::uint64_t left = size_ - offset_;
    if (left == 0) return stop(Ended::whole);
    if (left < kFrameHeadBytes || !take(head_, kFrameHeadBytes)) return stop(Ended::cut);
    ByteReader head(head_);
    frame.kind = head.u32();
    const std::uint32_t length = head.u32();
    if (chain_.addHead(frame.kind, length) != head.u32()) return stop(Ended::damaged);
    if (left < kFrameBytes + length) return stop(Ended::cut);
    if (!take(frame.content, length) || !take(hash_, sizeof(std::uint64_t))) return stop(Ended::cut);
    if (chain_.addContent(frame.content) != ByteReader(hash_).u64()) return stop(Ended::damaged);
    frame.offset = offset_;
    frame.number = ++frames_;
    offset_ += kFrameBytes + length;
    return true;
}

} // namespace meltpool
