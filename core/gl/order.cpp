#include "core/gl/order.hpp"

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

} // namespace meltpool::gl
