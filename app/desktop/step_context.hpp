// Provides the OpenGL context of the thread that makes the metal's steps.
#pragma once

#include "core/gl/context.hpp"
#include "core/gl/program.hpp"

#include <filesystem>
#include <optional>

namespace meltpool {

/// OpenGL context of one thread. Any thread may make and destroy it; all other calls belong to its own thread.
class StepContext {
  public:
    virtual ~StepContext() = default;
    /// Makes it the calling thread's context; returns false if none is suitable.
    virtual bool enter() = 0;
    /// Releases the calling thread's context.
    virtual void leave() = 0;
    /// Programs of the context, valid between enter() and leave().
    virtual gl::ShaderLibrary& shaders() = 0;
};

/// Shares nothing with the window's context, so that dispatches of one do not wait for those of the other.
class HeadlessStepContext final : public StepContext {
  public:
    /// `shaders`: the folder of the programs.
    explicit HeadlessStepContext(std::filesystem::path shaders) : root_(std::move(shaders)) {}
    /// Returns false if its dispatches would not be synchronous, or if no driver serves.
    bool enter() override;
    void leave() override;
    gl::ShaderLibrary& shaders() override { return *shaders_; }

  private:
    std::filesystem::path root_;
    std::optional<gl::HeadlessContext> context_;
    std::optional<gl::ShaderLibrary> shaders_;
};

} // namespace meltpool
