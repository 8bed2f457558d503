// Defines the frames of a recording: kind, length and content, each with a hash over everything before it.
#pragma once

#include "core/base/hash.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// The first bytes of every recording. Sending the file as text changes them.
inline constexpr std::string_view kRecordingSignature("\x89MPR\r\n\x1A\n", 8);

/// Four letters as the number in the file.
constexpr std::uint32_t frameKind(const char (&letters)[5]) {
    std::uint32_t kind = 0;
    for (int i = 3; i >= 0; --i)
        kind = kind << 8 | static_cast<unsigned char>(letters[i]);
    return kind;
}

enum class FrameKind : std::uint32_t {
    head = frameKind("HEAD"),
    step = frameKind("STEP"),
    person = frameKind("PERS"),
    change = frameKind("SETV"),
    event = frameKind("EVNT"),
    checkpoint = frameKind("CHKP"),
    end = frameKind("END "),
};

/// Bytes of kind, length of the content, and the head's own check: u32 each.
inline constexpr size_t kFrameHeadBytes = 12;
/// Bytes that a frame adds to its content.
inline constexpr size_t kFrameBytes = kFrameHeadBytes + sizeof(std::uint64_t);

/// The hash that runs through a file: FNV-1a, 64 bits, over the signature and over kind, length and content of each
/// frame. Each byte changes it one to one, so a changed byte always gives another hash in its own frame.
class FrameChain {
  public:
    FrameChain() { add(kRecordingSignature); }

    /// Adds a frame's kind and length; returns the check that follows them: the hash's lower half. It distinguishes a
    /// changed length from a file that was cut.
    std::uint32_t addHead(std::uint32_t kind, std::uint32_t length);
    /// Adds the content; returns the hash that follows it.
    std::uint64_t addContent(std::string_view content);

  private:
    void add(std::string_view bytes) { hash_.add(std::span<const char>(bytes.data(), bytes.size())); }

    StateHash hash_;
};

/// Appends a whole frame to `file`.
void appendFrame(std::string& file, FrameChain& chain, std::uint32_t kind, std::string_view content);

struct RecordingFrame {
    std::uint32_t kind = 0;
    size_t number = 0;        ///< number of the frame, from 1
    std::uint64_t offset = 0; ///< offset of its first byte in the file
    std::string content;

    bool is(FrameKind wanted) const { return kind == static_cast<std::uint32_t>(wanted); }
};

/// Reads the frames of a file in order and stops at the first that is not whole.
class FrameReader {
  public:
    /// Throws InputError if the file cannot be read or does not begin like a recording.
    explicit FrameReader(const std::filesystem::path& file);

    /// Reads the next frame into `frame`. False at the end of the file and at a fault; ended() tells which.
    bool next(RecordingFrame& frame);

    enum class Ended {
        not_,    ///< there may be more frames
        whole,   ///< the file ends after a frame
        cut,     ///< the file ends inside a frame
        damaged, ///< the bytes differ from the written ones
    };
    Ended ended() const { return ended_; }
    /// Offset of the next frame, or of the frame with the fault.
    std::uint64_t offset() const { return offset_; }
    /// Number of whole frames so far.
    size_t frames() const { return frames_; }

  private:
    bool take(std::string& bytes, std::uint64_t count);
    bool stop(Ended how) {
        ended_ = how;
        return false;
    }

    std::ifstream stream_;
    std::uint64_t size_ = 0; ///< size of the file when it was opened
    std::uint64_t offset_ = 0;
    size_t frames_ = 0;
    FrameChain chain_;
    std::string head_;
    std::string hash_;
    Ended ended_ = Ended::not_;
};

} // namespace meltpool
