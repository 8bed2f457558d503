// A whole state as bytes: the same code saves it and restores it, numbers of the CPU and buffers of the GPU alike, so
// that neither can forget what the other knows.
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

/// A stretch of a state's bytes that changes, and packs, as one.
struct StatePart {
    size_t bytes = 0;
    bool list = false;   ///< of slots or other whole numbers that mostly differ little from the one before
    bool onGpu = false;  ///< while it is being saved: it comes from a buffer
    size_t rowWords = 1; ///< 4-byte words of a row, where it is a table: a column's words resemble each other

    bool operator==(const StatePart&) const = default;
};

/// A state while it is being saved: what the CPU knew, and where on the GPU the rest lies.
struct StateParts {
    struct Region {
        GLuint buffer = 0;
        size_t bytes = 0;
        /// The buffer's own where it was named on a BarrierFreeThread, whose context may be another one than that which
        /// copies: any thread reads it as long as no shader writes there.
        const std::byte* memory = nullptr;
    };
    std::vector<std::byte> numbers; ///< of all parts that are not on the GPU, one after the other
    std::vector<StatePart> parts;
    std::vector<Region> regions; ///< of the others, in their order
};

/// Each class that has a state of its own has a function `void transfer(StateArchive&)` that names its members once.
/// Where bytes are restored every size is checked: bytes that are too short, or of another state, throw InputError.
class StateArchive {
  public:
    /// Saves.
    explicit StateArchive(StateParts& into);
    /// Saves numbers alone, behind what `into` holds.
    explicit StateArchive(std::vector<std::byte>& into) : numbers_(&into) {}
    /// Restores from bytes that stay where they are.
    explicit StateArchive(std::span<const std::byte> from);

    bool restores() const { return numbers_ == nullptr; }
    /// All bytes were taken.
    bool atEnd() const { return at_ == from_.size(); }

    /// Plain values: numbers, enumerations, vectors of numbers, structs of these without gaps.
    template <class... T>
    void values(T&... each) {
        (value(each), ...);
    }

    /// A number of things that are at most `most`.
    void count(size_t& number, size_t most);
    void text(std::string& words);

    /// The first `bytes` bytes of a buffer. Where it is restored the rest of the buffer becomes zero.
    void buffer(const Buffer& buffer, size_t bytes) { part(buffer, {bytes}); }
    /// The same of whole numbers, see StatePart::list.
    void list(const Buffer& buffer, size_t bytes) { part(buffer, {bytes, true}); }
    /// The same of `count` vectors or structs of `rowBytes`, a multiple of 4.
    void rows(const Buffer& buffer, size_t count, size_t rowBytes) {
        part(buffer, {count * rowBytes, false, false, rowBytes / 4});
    }

    /// An answer that is under way or has not been taken yet. Where it is restored it comes again by way of `source`,
    /// the buffer that it was read from.
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

    std::vector<std::byte>* numbers_ = nullptr; ///< null while restoring
    StateParts* parts_ = nullptr;
    std::span<const std::byte> from_;
    size_t at_ = 0;
    std::optional<Buffer> upload_; ///< all of from_ on the GPU
};

/// A state on its way from the GPU: the copy is made there in the order of the commands, so that nothing waits, and
/// comes to the CPU frames later.
class StateCapture {
  public:
    StateCapture() = default;
    ~StateCapture();
    StateCapture(const StateCapture&) = delete;
    StateCapture& operator=(const StateCapture&) = delete;

    /// Where the state is to be saved to; what was under way is dropped.
    StateParts& begin();
    /// Copies on the GPU what begin()'s parts name, as it is after the commands issued so far. Never waits. Parts in
    /// memory of their own are copied at once, without OpenGL.
    void request();
    /// Whether the copy has come. Never waits; false also where none was asked for.
    bool arrived();
    /// Waits for it.
    void wait();

    /// Puts the bytes of all parts one after the other; after arrived() or wait(). Any thread may do this, but the next
    /// begin() must wait for it.
    void assemble(std::vector<std::byte>& bytes, std::vector<StatePart>& parts) const;

    size_t bytes() const { return room_ + memory_.capacity(); } ///< of the copy

  private:
    void makeRoom(size_t bytes);
    void copyMemory();
    void copyBuffers();
    void forget();

    StateParts state_;
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
    Handle<destroy> copy_;
    const void* mapped_ = nullptr;
    size_t room_ = 0;
    std::vector<std::byte> memory_;     ///< the copy of what lay in memory
    const std::byte* copied_ = nullptr; ///< the copy, one or the other
    GLsync fence_ = nullptr;
    bool arrived_ = false;
};

} // namespace meltpool::gl
