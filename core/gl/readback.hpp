// Reads small results from the GPU frames later, without waiting.
#pragma once

#include "core/gl/buffer.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace meltpool::gl {

/// Copies bytes of a buffer on the GPU and returns them once the GPU has executed the copy. One request at a time; a
/// request while one is pending is ignored.
class Readback {
  public:
    Readback(std::string_view label, size_t bytes);
    ~Readback();
    Readback(const Readback&) = delete;
    Readback& operator=(const Readback&) = delete;

    /// Requests the bytes of `source` from byte `offset` on, after the commands issued so far. Throws RuntimeFault if
    /// they reach past the end of the buffer.
    void request(const Buffer& source, size_t offset = 0);

    /// The answer, once, if it has arrived. Never waits.
    template <class T>
    std::optional<T> poll() {
        T value{};
        return sizeof(T) <= bytes_ && take(&value, sizeof(T)) ? std::optional<T>(value) : std::nullopt;
    }

    /// The answer, once; waits for the GPU. Nothing if there was no request.
    template <class T>
    std::optional<T> await() {
        wait();
        return poll<T>();
    }

    /// The answer without a copy, or nullptr; valid until the next request. Never waits.
    const void* pollInPlace();
    /// True while an answer is under way or was not taken.
    bool pending() const { return asked_; }
    /// The GL name of its memory, for saving a state.
    GLuint name() const { return handle_.name(); }
    size_t bytes() const { return bytes_; }
    /// Discards a pending request.
    void forget();
    /// Waits for the answer; returns at once if there was no request.
    void wait() const;

  private:
    bool take(void* target, size_t bytes);

    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
    Handle<destroy> handle_;
    const void* mapped_ = nullptr;
    GLsync fence_ = nullptr; ///< null also if the copy ended at once
    bool asked_ = false;
    size_t bytes_ = 0;
};

/// A queue of reads; answers come in the order of their requests.
class ReadbackQueue {
  public:
    /// `depth`: most reads under way at a time.
    ReadbackQueue(std::string_view label, size_t bytes, size_t depth);

    size_t pending() const { return pending_; }
    bool full() const { return pending_ == slots_.size(); }

    /// As Readback::request(). Throws RuntimeFault when full().
    void request(const Buffer& source);
    /// The oldest answer that was not taken, if it has arrived; else nullptr. Never waits. Valid until the next
    /// request.
    const void* pollInPlace();
    /// The oldest answer that was not taken; waits for the GPU. nullptr only if nothing is pending.
    const void* awaitInPlace();
    /// Discards pending requests.
    void forget();

    size_t bytes() const { return bytes_; }

  private:
    std::vector<std::unique_ptr<Readback>> slots_;
    size_t bytes_;
    size_t oldest_ = 0;
    size_t pending_ = 0;
};

} // namespace meltpool::gl
