#include "core/gl/order.hpp"

#include <array>
#include <cstring>
#include <string_view>

namespace meltpool::gl {

namespace {

thread_local bool inOrder = false;

} // namespace

bool dispatchesEndAtOnce() {
    const GLubyte* renderer = glGetString(GL_RENDERER);
    return renderer != nullptr &&
           std::string_view(reinterpret_cast<const char*>(renderer)).find("llvmpipe") != std::string_view::npos;
}

InOrderThread::InOrderThread() {
    inOrder = true;
}

InOrderThread::~InOrderThread() {
    inOrder = false;
}

void memoryBarrier(GLbitfield barriers) {
    if (!inOrder) glMemoryBarrier(barriers);
}

GLsync fence() {
    return inOrder ? nullptr : glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

GLbitfield directStorage() {
    return dispatchesEndAtOnce() ? GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT : 0;
}

// Such a driver gives the buffer's memory itself, which may be read too. A mapping for reading could not be
// unsynchronized, and what is synchronized is looked for in pictures.
void mapDirectly(GLuint buffer, size_t bytes) {
    if (const GLbitfield flags = directStorage(); flags != 0)
        glMapNamedBufferRange(buffer, 0, static_cast<GLsizeiptr>(bytes), flags | GL_MAP_UNSYNCHRONIZED_BIT);
}

std::byte* directMemory(GLuint buffer) {
    if (!inOrder) return nullptr;
    void* memory = nullptr;
    glGetNamedBufferPointerv(buffer, GL_BUFFER_MAP_POINTER, &memory);
    return static_cast<std::byte*>(memory);
}

void copyBytes(GLuint from, GLuint to, size_t bytes, size_t fromOffset, size_t toOffset) {
    const std::byte* source = directMemory(from);
    std::byte* target = directMemory(to);
    if (source != nullptr && target != nullptr)
        std::memmove(target + toOffset, source + fromOffset, bytes);
    else
        glCopyNamedBufferSubData(from, to, static_cast<GLintptr>(fromOffset), static_cast<GLintptr>(toOffset),
                                 static_cast<GLsizeiptr>(bytes));
}

void fillWords(GLuint buffer, size_t offset, size_t bytes, GLuint word) {
    if (std::byte* memory = directMemory(buffer)) {
        for (size_t at = offset; at < offset + bytes; at += sizeof word)
            std::memcpy(memory + at, &word, sizeof word);
        return;
    }
    glClearNamedBufferSubData(buffer, GL_R32UI, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                              GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
}

void dispatchIndirect(size_t offset) {
    GLint counts = 0;
    if (inOrder) glGetIntegerv(GL_DISPATCH_INDIRECT_BUFFER_BINDING, &counts);
    const std::byte* memory = counts != 0 ? directMemory(static_cast<GLuint>(counts)) : nullptr;
    if (memory == nullptr) {
        glDispatchComputeIndirect(static_cast<GLintptr>(offset));
        return;
    }
    std::array<GLuint, 3> groups{};
    std::memcpy(groups.data(), memory + offset, sizeof groups);
    glDispatchCompute(groups[0], groups[1], groups[2]);
}

} // namespace meltpool::gl
