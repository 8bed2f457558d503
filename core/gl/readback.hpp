// Reads small results from the GPU frames later, without waiting.
#pragma once

#include "core/gl/buffer.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace meltpool::gl {

/// Copies bytes of a buffer on the GPU and gives them to the caller once the GPU has executed the copy. One request at
/// a time; a request while one is pending is ignored.
class Readback {
  public:
    Readback(std::string_view label, size_t bytes);
    ~Readback();
    Readback(const Readback&) = delete;
    Readback& operator=(const Readback&) = delete;

    /// Requests the bytes of `source` from byte `offset` on, as they are after the commands issued so far. Throws
    /// RuntimeFault when they reach past the end of the buffer.
    void request(const Buffer& source, size_t offset = 0);

    /// The answer when it has arrived, once. Never waits.
    template <class T>
    std::optional<T> poll() {
        T value{};
        return sizeof(T) <= bytes_ && take(&value, sizeof(T)) ? std::optional<T>(value) : std::nullopt;
    }

    /// The answer, once, waiting for the GPU to get there; nothing where none was asked for.
    template <class T>
    std::optional<T> await() {
        wait();
        return poll<T>();
    }

    /// The same without copying: nullptr while there is none; valid until the next request.
    const void* pollInPlace();
    /// An answer is under way or was not taken yet.
    bool pending() const { return asked_; }
    /// Its memory on the GPU, for those who save a state.
    GLuint name() const { return handle_.name(); }
    size_t bytes() const { return bytes_; }
    /// Discards a pending request.
    void forget();
    /// Waits until the answer is there; returns at once where none was asked for.
    void wait() const;

  private:
    bool take(void* target, size_t bytes);

    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
    Handle<destroy> handle_;
    const void* mapped_ = nullptr;
    GLsync fence_ = nullptr; ///< null also where the copy has ended at once
    bool asked_ = false;
    size_t bytes_ = 0;
};

/// Several reads under way, answered in the order in which they were asked for.
class ReadbackQueue {
  public:
    /// `depth`: reads that may be under way at a time.
    ReadbackQueue(std::string_view label, size_t bytes, size_t depth);

    size_t pending() const { return pending_; }
    bool full() const { return pending_ == slots_.size(); }

    /// As Readback::request(). Throws RuntimeFault when full().
    void request(const Buffer& source);
    /// The oldest answer that has not been given, where it has arrived; else nullptr. Never waits. Valid until the next
    /// request.
    const void* pollInPlace();
    /// The same, waiting for the GPU; nullptr only where nothing is pending.
    const void* awaitInPlace();
    /// Drops what is pending.
    void forget();

    size_t bytes() const { return bytes_; }

  private:
    std::vector<std::unique_ptr<Readback>> slots_;
    size_t bytes_;
    size_t oldest_ = 0;
    size_t pending_ = 0;
};

} // namespace meltpool::gl
