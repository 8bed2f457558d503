#include "core/gl/buffer.hpp"

#include "core/base/error.hpp"
#include "core/gl/order.hpp"
#include "core/gl/software_driver/software_driver.hpp"

#include <algorithm>

namespace meltpool::gl {

Buffer::Buffer(std::string_view label, size_t bytes, GLbitfield storageFlags)
    : label_(label),
      bytes_((std::max<size_t>(bytes, 1) + 3) / 4 * 4),
      writable_((storageFlags & GL_DYNAMIC_STORAGE_BIT) != 0) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    handle_ = Handle<destroy>(name);
    labelObject(GL_BUFFER, name, label);
    while (glGetError() != GL_NO_ERROR) {
    }
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes_), nullptr, storageFlags | directStorage());
    if (glGetError() == GL_OUT_OF_MEMORY)
        throw RuntimeFault("the graphics driver has no room for " + std::to_string(bytes_ >> 20) + " MiB ('" +
                           std::string(label) + "'); use fewer particles or a coarser grid");
    mapDirectly(name, bytes_);
    clear();
}

void Buffer::clear() const {
    fill(0);
}

void Buffer::fill(GLuint word) const {
    fillWords(name(), 0, bytes_, word);
}

void Buffer::resize(size_t bytes) {
    Buffer other(label_, bytes, writable_ ? GL_DYNAMIC_STORAGE_BIT : 0);
    memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    copyTo(other, std::min(bytes_, other.bytes_));
    *this = std::move(other);
}

void Buffer::copyTo(const Buffer& target, size_t bytes, size_t from, size_t to) const {
    copyBytes(name(), target.name(), bytes, from, to);
}

void Buffer::writeBytes(const void* data, size_t bytes, size_t offset) {
    if (bytes == 0) return;
    if (!writable_) throw RuntimeFault("a write to a GPU buffer that only the GPU writes was refused");
    if (offset + bytes > bytes_) throw RuntimeFault("a write past the end of a GPU buffer was refused");
    if (!writeDirectly(name(), data, bytes, offset))
        glNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::readBytes(void* data, size_t bytes, size_t offset) const {
    if (bytes == 0) return;
    if (offset + bytes > bytes_) throw RuntimeFault("a read past the end of a GPU buffer was refused");
    memoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    if (!readDirectly(name(), data, bytes, offset))
        glGetNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

} // namespace meltpool::gl
