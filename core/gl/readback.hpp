// Small results that come back from the GPU frames later, without a wait.
#pragma once

#include "core/gl/buffer.hpp"

#include <optional>

namespace meltpool::gl {

/// Copies bytes of a buffer aside on the GPU and hands them over once the GPU has got there. One request at a time; a
/// request while one is under way is dropped, as its answer would be older than the caller thinks.
class Readback {
  public:
    Readback(std::string_view label, size_t bytes);
    ~Readback();
    Readback(const Readback&) = delete;
    Readback& operator=(const Readback&) = delete;

    /// Asks for the bytes of `source` from byte `offset` on, as the commands so far leave them.
    void request(const Buffer& source, size_t offset = 0);

    /// The answer, once; nothing while there is none. Never waits.
    template <class T>
    std::optional<T> poll() {
        T value{};
        return sizeof(T) <= bytes_ && take(&value, sizeof(T)) ? std::optional<T>(value) : std::nullopt;
    }

    /// The answer where it lies, once; nullptr while there is none. Valid until the next request. Never waits.
    const void* pollInPlace();
    /// Drops what is on its way.
    void forget();

  private:
    bool take(void* target, size_t bytes);

    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
    Handle<destroy> handle_;
    const void* mapped_ = nullptr;
    GLsync fence_ = nullptr;
    size_t bytes_ = 0;
};

} // namespace meltpool::gl
