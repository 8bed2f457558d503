// The OpenGL context of the thread that makes the metal's steps.
#pragma once

#include "core/gl/context.hpp"
#include "core/gl/program.hpp"

#include <filesystem>
#include <optional>

namespace meltpool {

/// Made and destroyed on any thread; all else on the one that it is for.
class StepContext {
  public:
    virtual ~StepContext() = default;
    /// Makes it the calling thread's context; false where there is none that serves.
    virtual bool enter() = 0;
    /// The calling thread has no context any more.
    virtual void leave() = 0;
    /// Its programs, between these two.
    virtual gl::ShaderLibrary& shaders() = 0;
};

/// Shares nothing with the window's context, so that dispatches of one do not wait for those of the other.
class HeadlessStepContext final : public StepContext {
  public:
    /// `shaders`: the folder that programs are loaded from.
    explicit HeadlessStepContext(std::filesystem::path shaders) : root_(std::move(shaders)) {}
    /// False where its dispatches would not end at once, or no driver serves.
    bool enter() override;
    void leave() override;
    gl::ShaderLibrary& shaders() override { return *shaders_; }

  private:
    std::filesystem::path root_;
    std::optional<gl::HeadlessContext> context_;
    std::optional<gl::ShaderLibrary> shaders_;
};

} // namespace meltpool
