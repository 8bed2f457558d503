#include "core/gl/context.hpp"

#include "core/base/error.hpp"
#include "core/base/last_facts.hpp"
#include "core/gl/software_driver/software_driver.hpp"

#include <cstdio>

namespace meltpool::gl {

namespace {

std::string textOf(GLenum what) {
    const GLubyte* text = glGetString(what);
    return text == nullptr ? std::string() : reinterpret_cast<const char*>(text);
}

void GLAPIENTRY reportDebugMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
                                   const void*) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || type == GL_DEBUG_TYPE_PERFORMANCE) return;
    std::fprintf(stderr, "OpenGL: %s\n", message);
}

} // namespace

bool drawnOnProcessor() {
    return drawsOnProcessor(textOf(GL_RENDERER));
}

ContextInfo useCurrentContext(bool debug) {
    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    // GLEW reports the missing GLX display after it has loaded every function of an EGL context: not an error.
    if (status != GLEW_OK && status != GLEW_ERROR_NO_GLX_DISPLAY)
        throw InputError(std::string("the OpenGL functions cannot be loaded: ") +
                         reinterpret_cast<const char*>(glewGetErrorString(status)));
    while (glGetError() != GL_NO_ERROR) {
    }
    ContextInfo info{textOf(GL_RENDERER), textOf(GL_VENDOR), textOf(GL_VERSION)};
    glGetIntegerv(GL_MAJOR_VERSION, &info.major);
    glGetIntegerv(GL_MINOR_VERSION, &info.minor);
    info.software = drawsOnProcessor(info.renderer);
    noteFact(LastFact::driver, info.version + " on " + info.renderer);
    if (info.major * 10 + info.minor < 45)
        throw InputError("the graphics driver '" + info.renderer + "' offers OpenGL " + std::to_string(info.major) +
                         "." + std::to_string(info.minor) + "; expected 4.5 core or newer");
    if (debug) reportFaults();
    return info;
}

void reportFaults() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(reportDebugMessage, nullptr);
}

} // namespace meltpool::gl
