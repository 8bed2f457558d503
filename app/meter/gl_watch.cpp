#include "app/meter/gl_watch.hpp"

#include "core/base/work_meter.hpp"
#include "core/gl/gl.hpp"

#include <array>

#if defined(__linux__)

#include <dlfcn.h>

// Functions that are newer than OpenGL 1.1 are variables of the loader, which are exchanged.
// clang-format off
#define NEWER_CALLS(W) \
    W(glAttachShader) W(glBindBuffer) W(glBindBufferBase) W(glBindFramebuffer) W(glBindImageTexture) \
    W(glBindSampler) W(glBindTextureUnit) W(glBindVertexArray) W(glBlitNamedFramebuffer) \
    W(glCheckNamedFramebufferStatus) W(glClearBufferfv) W(glClearNamedBufferData) W(glClientWaitSync) \
    W(glCompileShader) W(glCopyNamedBufferSubData) W(glCreateBuffers) W(glCreateFramebuffers) W(glCreateProgram) \
    W(glCreateQueries) W(glCreateSamplers) W(glCreateShader) W(glCreateTextures) W(glCreateVertexArrays) \
    W(glDebugMessageCallback) W(glDeleteBuffers) W(glDeleteFramebuffers) W(glDeleteProgram) W(glDeleteQueries) \
    W(glDeleteSamplers) W(glDeleteShader) W(glDeleteSync) W(glDeleteVertexArrays) W(glDetachShader) \
    W(glDisableVertexArrayAttrib) W(glDispatchCompute) W(glDispatchComputeIndirect) W(glDrawArraysIndirect) \
    W(glDrawArraysInstanced) W(glDrawElementsIndirect) W(glEnableVertexArrayAttrib) W(glFenceSync) \
    W(glGenerateTextureMipmap) W(glGetActiveUniform) W(glGetInteger64v) W(glGetNamedBufferSubData) W(glGetProgramInfoLog) \
    W(glGetProgramiv) W(glGetQueryObjectiv) W(glGetQueryObjectui64v) W(glGetShaderInfoLog) W(glGetShaderiv) \
    W(glGetStringi) W(glGetTextureImage) W(glGetUniformLocation) W(glLinkProgram) W(glMapNamedBufferRange) \
    W(glMemoryBarrier) W(glNamedBufferStorage) W(glNamedBufferSubData) W(glNamedFramebufferTexture) \
    W(glNamedFramebufferTextureLayer) W(glObjectLabel) W(glPopDebugGroup) W(glProgramUniform1f) \
    W(glProgramUniform1i) W(glProgramUniform1ui) W(glProgramUniform2f) W(glProgramUniform3f) W(glProgramUniform4f) \
    W(glProgramUniformMatrix4fv) W(glPushDebugGroup) W(glQueryCounter) W(glSamplerParameteri) W(glScissorIndexed) \
    W(glShaderSource) W(glTextureBuffer) W(glTextureParameteri) W(glTextureStorage2D) \
    W(glTextureStorage2DMultisample) W(glTextureStorage3D) W(glTextureStorage3DMultisample) W(glTextureSubImage2D) \
    W(glTextureSubImage3D) W(glUseProgram) W(glVertexArrayAttribBinding) W(glVertexArrayAttribFormat) \
    W(glVertexArrayElementBuffer) W(glVertexArrayVertexBuffer) W(glVertexAttrib1f) W(glViewportIndexedf) \
    W(glWaitSync)
// clang-format on

namespace {

void noteStall(const char* call) {
    if (meltpool::WorkMeter* meter = meltpool::WorkMeter::current()) meter->stalled(call);
}

/// Of OpenGL 1.1: hands pixels to our memory, or waits for its own sake.
constexpr bool waits(std::string_view call) {
    return call == "glFinish" || call == "glReadPixels";
}

} // namespace

namespace meltpool {

namespace {

/// Calls that may wait for the GPU; everything else does not.
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

template <auto Slot>
struct Hook;

template <class Result, class... Arguments, Result(GLAPIENTRY** Slot)(Arguments...)>
struct Hook<Slot> {
    static inline Result(GLAPIENTRY* original)(Arguments...) = nullptr;
    static inline const char* name = "";

    static Result GLAPIENTRY call(Arguments... arguments) {
        const InWork driver(WorkPlace::driver);
        if (WorkMeter::current() != nullptr && MayWait<Slot>::now(arguments...)) noteStall(name);
        return original(arguments...);
    }
    static void install(const char* called) {
        if (*Slot == nullptr || *Slot == &call) return;
        name = called;
        original = *Slot;
        *Slot = &call;
    }
};

} // namespace

bool watchGl() {
#define INSTALL(call) Hook<&call>::install(#call);
    NEWER_CALLS(INSTALL)
#undef INSTALL
    return true;
}

std::span<const std::string_view> watchedGlCalls() {
#define NAME(call) #call,
    static constexpr std::string_view kNames[] = {NEWER_CALLS(NAME) "glEnable",
                                                  "glDisable",
                                                  "glGetIntegerv",
                                                  "glViewport",
                                                  "glGetError",
                                                  "glClearColor",
                                                  "glClear",
                                                  "glScissor",
                                                  "glFinish",
                                                  "glFlush",
                                                  "glDepthMask",
                                                  "glPixelStorei",
                                                  "glDepthFunc",
                                                  "glDeleteTextures",
                                                  "glIsTexture",
                                                  "glDrawArrays",
                                                  "glCullFace",
                                                  "glBlendFunc",
                                                  "glReadPixels",
                                                  "glGenTextures",
                                                  "glBindTexture",
                                                  "glGetString"};
#undef NAME
    return kNames;
}

} // namespace meltpool

// Those of OpenGL 1.1 are the driver library's own symbols: the program's definitions come first and hand on.
#define WATCHED(Result, call, parameters, arguments)                                                                   \
    Result GLAPIENTRY call parameters {                                                                                \
        static const auto original = reinterpret_cast<Result(*) parameters>(dlsym(RTLD_NEXT, #call));                  \
        const meltpool::InWork driver(meltpool::WorkPlace::driver);                                                    \
        if (waits(#call)) noteStall(#call);                                                                            \
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

#else

namespace meltpool {

bool watchGl() {
    return false;
}

std::span<const std::string_view> watchedGlCalls() {
    return {};
}

} // namespace meltpool

#endif
