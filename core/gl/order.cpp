#include "core/gl/order.hpp"

#include "core/gl/software_driver/software_driver.hpp"

namespace meltpool::gl {

void memoryBarrier(GLbitfield barriers) {
    if (!barrierFree()) glMemoryBarrier(barriers);
}

GLsync fence() {
    return barrierFree() ? nullptr : glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

void copyBytes(GLuint from, GLuint to, size_t bytes, size_t fromOffset, size_t toOffset) {
    if (copyDirectly(from, to, bytes, fromOffset, toOffset)) return;
    glCopyNamedBufferSubData(from, to, static_cast<GLintptr>(fromOffset), static_cast<GLintptr>(toOffset),
                             static_cast<GLsizeiptr>(bytes));
}

void fillWords(GLuint buffer, size_t offset, size_t bytes, GLuint word) {
    if (fillDirectly(buffer, offset, bytes, word)) return;
    glClearNamedBufferSubData(buffer, GL_R32UI, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                              GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
}

void dispatchIndirect(size_t offset) {
    if (!dispatchDirectly(offset)) glDispatchComputeIndirect(static_cast<GLintptr>(offset));
}

} // namespace meltpool::gl
