// Counts the operations that a frame of the program must avoid: requests to the heap, and OpenGL calls that wait for
// the GPU. The library is loaded before the program (LD_PRELOAD). It also informs the program when its threads are
// inside the driver. It counts operator new, not the memory that drivers and C libraries take by other ways.
#include "app/platform/call_counters.hpp"
#include "core/gl/gl.hpp"
#include "tests/support/call_counters/gl_calls.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <new>

namespace {

// A thread-local variable of the usual kind would ask the heap itself.
[[gnu::tls_model("initial-exec")]] thread_local std::uint64_t allocations = 0;

const meltpool::CallListener* listener = nullptr; ///< nullptr: no listener yet

/// Marks the thread as inside the driver during its lifetime.
class InDriver {
  public:
    InDriver() : before_(listener == nullptr ? -1 : listener->enterDriver()) {}
    ~InDriver() {
        if (before_ >= 0) listener->leaveDriver(before_);
    }
    InDriver(const InDriver&) = delete;
    InDriver& operator=(const InDriver&) = delete;

    bool measured() const { return before_ >= 0; }
    void stalled(const char* call) const {
        if (measured()) listener->stalled(call);
    }

  private:
    int before_;
};

/// Lists the calls that may wait for the GPU; no others do.
template <auto Slot>
struct MayWait {
    template <class... Arguments>
    static bool now(Arguments...) {
        return false;
    }
};

template <>
struct MayWait<&glGetNamedBufferSubData> {
    static bool now(GLuint, GLintptr, GLsizeiptr, void*) { return true; }
};

template <>
struct MayWait<&glGetTextureImage> {
    static bool now(GLuint, GLint, GLenum, GLenum, GLsizei, void*) { return true; }
};

template <>
struct MayWait<&glMapNamedBufferRange> {
    static bool now(GLuint, GLintptr, GLsizeiptr, GLbitfield access) { return (access & GL_MAP_READ_BIT) != 0; }
};

template <>
struct MayWait<&glClientWaitSync> {
    static bool now(GLsync, GLbitfield, GLuint64 timeout) { return timeout > 0; }
};

template <>
struct MayWait<&glGetQueryObjectui64v> {
    static bool now(GLuint query, GLenum what, GLuint64*) {
        if (what != GL_QUERY_RESULT) return false;
        GLint ready = GL_TRUE;
        glGetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &ready);
        return ready == GL_FALSE;
    }
};

/// Replaces one of GLEW's variables and calls its former function.
template <auto Slot>
struct Hook;

template <class Result, class... Arguments, Result(GLAPIENTRY** Slot)(Arguments...)>
struct Hook<Slot> {
    static inline Result(GLAPIENTRY* original)(Arguments...) = nullptr;
    static inline const char* name = "";

    static Result GLAPIENTRY call(Arguments... arguments) {
        const InDriver driver;
        if (driver.measured() && MayWait<Slot>::now(arguments...)) driver.stalled(name);
        return original(arguments...);
    }
    static void install(const char* called) {
        if (*Slot == nullptr || *Slot == &call) return;
        name = called;
        original = *Slot;
        *Slot = &call;
    }
};

/// Returns true for calls of OpenGL 1.1 that hand pixels to our memory or exist to wait.
constexpr bool waits(std::string_view call) {
    return call == "glFinish" || call == "glReadPixels";
}

} // namespace

extern "C" meltpool::AllocationCount meltpool_listen_to_calls(const meltpool::CallListener* newListener) {
    listener = newListener;
#define INSTALL(call) Hook<&call>::install(#call);
    NEWER_GL_CALLS(INSTALL)
#undef INSTALL
    return [] { return allocations; };
}

// The standard library's own array and nothrow forms call these.
void* operator new(std::size_t bytes) {
    ++allocations;
    for (;;) {
        if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

// Calls of OpenGL 1.1: these definitions come before the driver library's and call those.
#define WATCHED(Result, call, parameters, arguments)                                                                   \
    Result GLAPIENTRY call parameters {                                                                                \
        static const auto original = reinterpret_cast<Result(*) parameters>(dlsym(RTLD_NEXT, #call));                  \
        const InDriver driver;                                                                                         \
        if (waits(#call)) driver.stalled(#call);                                                                       \
        return original arguments;                                                                                     \
    }

WATCHED(void, glEnable, (GLenum a), (a))
WATCHED(void, glDisable, (GLenum a), (a))
WATCHED(void, glGetIntegerv, (GLenum a, GLint* b), (a, b))
WATCHED(void, glViewport, (GLint a, GLint b, GLsizei c, GLsizei d), (a, b, c, d))
WATCHED(GLenum, glGetError, (void), ())
WATCHED(void, glClearColor, (GLclampf a, GLclampf b, GLclampf c, GLclampf d), (a, b, c, d))
WATCHED(void, glClear, (GLbitfield a), (a))
WATCHED(void, glScissor, (GLint a, GLint b, GLsizei c, GLsizei d), (a, b, c, d))
WATCHED(void, glFinish, (void), ())
WATCHED(void, glFlush, (void), ())
WATCHED(void, glDepthMask, (GLboolean a), (a))
WATCHED(void, glPixelStorei, (GLenum a, GLint b), (a, b))
WATCHED(void, glDepthFunc, (GLenum a), (a))
WATCHED(void, glDeleteTextures, (GLsizei a, const GLuint* b), (a, b))
WATCHED(GLboolean, glIsTexture, (GLuint a), (a))
WATCHED(void, glDrawArrays, (GLenum a, GLint b, GLsizei c), (a, b, c))
WATCHED(void, glCullFace, (GLenum a), (a))
WATCHED(void, glBlendFunc, (GLenum a, GLenum b), (a, b))
WATCHED(void, glReadPixels, (GLint a, GLint b, GLsizei c, GLsizei d, GLenum e, GLenum f, void* g),
        (a, b, c, d, e, f, g))
WATCHED(void, glGenTextures, (GLsizei a, GLuint* b), (a, b))
WATCHED(void, glBindTexture, (GLenum a, GLuint b), (a, b))
WATCHED(const GLubyte*, glGetString, (GLenum a), (a))
