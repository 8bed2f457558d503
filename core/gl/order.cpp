#include "core/gl/order.hpp"

#include "core/gl/software_driver/software_driver.hpp"

#include <array>
#include <cstring>

namespace meltpool::gl {

void memoryBarrier(GLbitfield barriers) {
    if (!barrierFree()) glMemoryBarrier(barriers);
}

GLsync fence() {
    return barrierFree() ? nullptr : glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
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
    if (barrierFree()) glGetIntegerv(GL_DISPATCH_INDIRECT_BUFFER_BINDING, &counts);
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
