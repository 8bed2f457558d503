// Lists the OpenGL calls that the counting library sees: every one in the program's own text.
#pragma once

#include <string_view>

// clang-format off
// Calls newer than OpenGL 1.1: variables of the loader GLEW.
#define NEWER_GL_CALLS(W) \
    W(glAttachShader) W(glBindBuffer) W(glBindBufferBase) W(glBindFramebuffer) W(glBindImageTexture) \
    W(glBindSampler) W(glBindTextureUnit) W(glBindVertexArray) W(glBlitNamedFramebuffer) \
    W(glCheckNamedFramebufferStatus) W(glClearBufferfv) W(glClearNamedBufferData) W(glClearNamedBufferSubData) W(glClientWaitSync) \
    W(glCompileShader) W(glCopyNamedBufferSubData) W(glCreateBuffers) W(glCreateFramebuffers) W(glCreateProgram) \
    W(glCreateQueries) W(glCreateSamplers) W(glCreateShader) W(glCreateTextures) W(glCreateVertexArrays) \
    W(glDebugMessageCallback) W(glDeleteBuffers) W(glDeleteFramebuffers) W(glDeleteProgram) W(glDeleteQueries) \
    W(glDeleteSamplers) W(glDeleteShader) W(glDeleteSync) W(glDeleteVertexArrays) W(glDetachShader) \
    W(glDisableVertexArrayAttrib) W(glDispatchCompute) W(glDispatchComputeIndirect) W(glDrawArraysIndirect) \
    W(glDrawArraysInstanced) W(glDrawElementsIndirect) W(glDrawElementsInstanced) \
    W(glDrawElementsInstancedBaseInstance) W(glEnableVertexArrayAttrib) W(glFenceSync) \
    W(glGenerateTextureMipmap) W(glGetActiveUniform) W(glGetInteger64v) W(glGetNamedBufferPointerv) W(glGetNamedBufferSubData) W(glGetNamedFramebufferParameteriv) W(glGetProgramInfoLog) \
    W(glGetProgramResourceIndex) W(glGetProgramResourceName) W(glGetProgramResourceiv) W(glGetProgramiv) W(glGetQueryObjectiv) W(glGetQueryObjectui64v) W(glGetShaderInfoLog) W(glGetShaderiv) \
    W(glGetStringi) W(glGetTextureImage) W(glGetUniformLocation) W(glLinkProgram) W(glMapNamedBufferRange) \
    W(glMemoryBarrier) W(glNamedBufferStorage) W(glNamedBufferSubData) W(glNamedFramebufferTexture) \
    W(glNamedFramebufferTextureLayer) W(glObjectLabel) W(glPopDebugGroup) W(glProgramUniform1f) \
    W(glProgramUniform1i) W(glProgramUniform1ui) W(glProgramUniform2f) W(glProgramUniform3f) W(glProgramUniform4f) \
    W(glProgramUniformMatrix4fv) W(glPushDebugGroup) W(glQueryCounter) W(glSamplerParameteri) W(glScissorIndexed) \
    W(glShaderSource) W(glTextureBuffer) W(glTextureParameteri) W(glTextureStorage2D) \
    W(glTextureStorage2DMultisample) W(glTextureStorage3D) W(glTextureStorage3DMultisample) W(glTextureSubImage2D) \
    W(glTextureSubImage3D) W(glUseProgram) W(glVertexArrayAttribBinding) W(glVertexArrayAttribFormat) W(glVertexArrayBindingDivisor) \
    W(glVertexArrayElementBuffer) W(glVertexArrayVertexBuffer) W(glVertexAttrib1f) W(glViewportIndexedf) \
    W(glWaitSync)

// Calls of OpenGL 1.1: functions of the driver's library.
#define OLDER_GL_CALLS(W) \
    W(glEnable) W(glDisable) W(glGetIntegerv) W(glViewport) W(glGetError) W(glClearColor) W(glClear) W(glColorMask) W(glScissor) \
    W(glFinish) W(glFlush) W(glDepthMask) W(glPixelStorei) W(glDepthFunc) W(glDeleteTextures) W(glIsTexture) \
    W(glDrawArrays) W(glCullFace) W(glBlendFunc) W(glReadPixels) W(glGenTextures) W(glBindTexture) W(glGetString)
// clang-format on

namespace meltpool::test {

#define MELTPOOL_NAME(call) #call,
inline constexpr std::string_view kCountedGlCalls[] = {NEWER_GL_CALLS(MELTPOOL_NAME) OLDER_GL_CALLS(MELTPOOL_NAME)};
#undef MELTPOOL_NAME

} // namespace meltpool::test
