// Unique ownership of GL objects.
#pragma once

#include "core/gl/gl.hpp"

#include <utility>

namespace meltpool::gl {

/// Names the object in debuggers and driver messages. `identifier` is GL_BUFFER, GL_TEXTURE, ...
inline void labelObject(GLenum identifier, GLuint name, std::string_view label) {
    glObjectLabel(identifier, name, static_cast<GLsizei>(label.size()), label.data());
}

/// Move-only owner of a GL name; its destructor calls `Delete`.
template <void (*Delete)(GLuint)>
class Handle {
  public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (name_ != 0) Delete(name_);
    }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

  private:
    GLuint name_ = 0;
};

} // namespace meltpool::gl
