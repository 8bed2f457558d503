// A whole state as bytes: one function saves and restores numbers of the CPU and buffers of the GPU, so that both
// directions name every member.
#pragma once

#include "core/gl/readback.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace meltpool::gl {

/// A range of a state's bytes that changes, and packs, as one.
struct StatePart {
    size_t bytes = 0;
    bool list = false;   ///< slots or other whole numbers that mostly differ little from the one before
    bool onGpu = false;  ///< true during saving: the bytes come from a buffer
    size_t rowWords = 1; ///< 4-byte words of a row in a table: a column's words resemble each other

    bool operator==(const StatePart&) const = default;
};

/// A state during saving: the numbers of the CPU, and the places of the rest on the GPU.
struct StateParts {
    struct Region {
        GLuint buffer = 0;
        size_t bytes = 0;
        /// The buffer's own memory if it was named on a BarrierFreeThread, whose context may differ from the one that
        /// copies: any thread may read it while no shader writes there.
        const std::byte* memory = nullptr;
    };
    std::vector<std::byte> numbers; ///< bytes of all parts that are not on the GPU, one after the other
    std::vector<StatePart> parts;
    std::vector<Region> regions; ///< places of the other parts, in order
};

/// Each class with a state of its own has a function `void transfer(StateArchive&)` that names its members once.
/// Restoring checks every size: bytes that are too short, or of another state, throw InputError.
class StateArchive {
  public:
    /// Saves into `into`.
    explicit StateArchive(StateParts& into);
    /// Saves only numbers, behind the content of `into`.
    explicit StateArchive(std::vector<std::byte>& into) : numbers_(&into) {}
    /// Restores from bytes that must stay in place.
    explicit StateArchive(std::span<const std::byte> from);

    bool restores() const { return numbers_ == nullptr; }
    /// True when all bytes were read.
    bool atEnd() const { return at_ == from_.size(); }

    /// Plain values: numbers, enumerations, vectors of numbers, structs of these without gaps.
    template <class... T>
    void values(T&... each) {
        (value(each), ...);
    }

    /// Transfers a count of at most `most`.
    void count(size_t& number, size_t most);
    void text(std::string& words);

    /// Transfers the first `bytes` bytes of a buffer. Restoring zeroes the rest of the buffer.
    void buffer(const Buffer& buffer, size_t bytes) { part(buffer, {bytes}); }
    /// Transfers a buffer of whole numbers, see StatePart::list.
    void list(const Buffer& buffer, size_t bytes) { part(buffer, {bytes, true}); }
    /// Transfers a buffer of `count` vectors or structs of `rowBytes`, a multiple of 4.
    void rows(const Buffer& buffer, size_t count, size_t rowBytes) {
        part(buffer, {count * rowBytes, false, false, rowBytes / 4});
    }

    /// Transfers an answer that is under way or was not taken. Restoring requests it again through `source`, the buffer
    /// that it was read from.
    void answer(Readback& readback, Buffer& source);

  private:
    template <class T>
    void value(T& each) {
        static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
        plain(&each, sizeof(T));
    }
    void value(bool& each);

    void plain(void* data, size_t bytes);
    void part(const Buffer& buffer, const StatePart& as);
    void region(GLuint buffer, const StatePart& as);
    std::span<const std::byte> take(size_t bytes);
    void copyTo(const Buffer& buffer, size_t bytes, size_t begin);

    std::vector<std::byte>* numbers_ = nullptr; ///< null during restoring
    StateParts* parts_ = nullptr;
    std::span<const std::byte> from_;
    size_t at_ = 0;
    std::optional<Buffer> upload_; ///< copy of from_ on the GPU
};

/// A state on its way from the GPU: the copy is made there in command order, so that nothing waits, and reaches the CPU
/// frames later.
class StateCapture {
  public:
    StateCapture() = default;
    ~StateCapture();
    StateCapture(const StateCapture&) = delete;
    StateCapture& operator=(const StateCapture&) = delete;

    /// The parts to save into; discards a pending copy.
    StateParts& begin();
    /// Copies on the GPU the parts that begin() returned, after the commands issued so far. Never waits. Parts in
    /// memory of their own are copied at once, without OpenGL.
    void request();
    /// True when the copy has arrived. Never waits; false also if there was no request.
    bool arrived();
    /// Waits for the copy.
    void wait();

    /// Joins the bytes of all parts; call it after arrived() or wait(). Any thread may do this, but the next begin()
    /// must wait for it.
    void assemble(std::vector<std::byte>& bytes, std::vector<StatePart>& parts) const;

    size_t bytes() const { return capacity_ + memory_.capacity(); } ///< memory of the copy

  private:
    void reserve(size_t bytes);
    void copyMemory();
    void copyBuffers();
    void forget();

    StateParts state_;
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
    Handle<destroy> copy_;
    const void* mapped_ = nullptr;
    size_t capacity_ = 0;
    std::vector<std::byte> memory_;     ///< copy of the parts in memory
    const std::byte* copied_ = nullptr; ///< either copy
    GLsync fence_ = nullptr;
    bool arrived_ = false;
};

} // namespace meltpool::gl
