// A block of GPU memory.
#pragma once

#include "core/gl/handle.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool::gl {

class Buffer {
  public:
    Buffer() = default;

    /// Zero-filled memory of `bytes` (rounded up to whole words, at least one, so that an empty list can be bound).
    /// Throws RuntimeFault if the driver has no memory.
    Buffer(std::string_view label, size_t bytes) : Buffer(label, bytes, GL_DYNAMIC_STORAGE_BIT) {}

    /// Memory that only the GPU writes, by shaders, clear(), fill() or copyTo(); write() throws RuntimeFault. Drivers
    /// can place it where the GPU reaches it fastest. Otherwise as the constructor.
    static Buffer gpuOnly(std::string_view label, size_t bytes) { return Buffer(label, bytes, 0); }

    /// Memory holding a copy of `values`.
    template <class T>
    Buffer(std::string_view label, std::span<const T> values) : Buffer(label, values.size_bytes()) {
        write(values);
    }

    size_t bytes() const { return bytes_; }
    GLuint name() const { return handle_.name(); }
    explicit operator bool() const { return static_cast<bool>(handle_); }

    /// Copies `values` to byte `offset`. Throws RuntimeFault if they do not fit.
    template <class T>
    void write(std::span<const T> values, size_t offset = 0) {
        writeBytes(values.data(), values.size_bytes(), offset);
    }
    template <class T>
    void writeValue(const T& value, size_t offset = 0) {
        writeBytes(&value, sizeof(T), offset);
    }

    /// Waits for the GPU and copies `count` values from byte `offset`. For tests, results and records; never inside a
    /// frame.
    template <class T>
    std::vector<T> read(size_t count, size_t offset = 0) const {
        std::vector<T> values(count);
        readBytes(values.data(), count * sizeof(T), offset);
        return values;
    }

    /// Sets every byte to zero on the GPU.
    void clear() const;
    /// Sets every 32-bit word on the GPU.
    void fill(GLuint word) const;
    /// Changes the size: the common bytes stay, zeros follow, and the GL name changes. The caller must bind the buffer
    /// again and remake its BufferViews. If the driver has no memory, throws RuntimeFault and leaves the buffer
    /// unchanged.
    void resize(size_t bytes);
    /// Copies `bytes` on the GPU, without the CPU.
    void copyTo(const Buffer& target, size_t bytes, size_t from = 0, size_t to = 0) const;

    void bindStorage(GLuint binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name()); }
    void bindUniform(GLuint binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, name()); }

  private:
    Buffer(std::string_view label, size_t bytes, GLbitfield storageFlags);
    void writeBytes(const void* data, size_t bytes, size_t offset);
    void readBytes(void* data, size_t bytes, size_t offset) const;

    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
    Handle<destroy> handle_;
    std::string label_;
    size_t bytes_ = 0;
    bool writable_ = true; ///< false: the CPU may not write it
};

} // namespace meltpool::gl
