// Makes the metal's steps on their own thread while the window's thread draws the frame's picture.
#pragma once

#include "app/desktop/step_thread.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace meltpool {

/// Times of steps made on another thread while a picture is drawn, s.
struct StepsBeside {
    double seconds = 0; ///< time from the steps' begin to the end of picture and steps
    double waited = 0;  ///< share of `seconds` spent waiting after the picture
};

/// Runs the steps of a frame: postpone() if the frame has steps for the thread, begin() before it draws, finish()
/// after.
class BackgroundSteps {
  public:
    /// Makes a thread only if the processor draws: a card runs in parallel with the processor anyway. `shaders`: the
    /// folder of the thread's shaders.
    explicit BackgroundSteps(const std::filesystem::path& shaders);

    /// Returns null without a thread.
    StepThread* thread() { return thread_.get(); }
    bool possible() const { return thread_ != nullptr; }

    /// Time that steps may take while a picture is drawn, s: the last frame's time less its waiting for steps.
    double timeBeside(double lastFrameSeconds) const;
    /// Makes this frame's steps wait for its picture. Call only if a thread is possible().
    void postpone() { due_ = true; }
    /// Returns true while steps are postponed and unfinished.
    bool due() const { return due_; }
    /// Begins the postponed steps, which `work` makes on the thread; no-op if none are due.
    void begin(std::function<void()> work);
    /// Waits for the end of the steps; throws the exception of `work`. Returns false if none were due.
    bool finish();
    /// Waits for running steps when the program ends; prints their fault to standard error.
    void abandon();

    /// Times of the last frame's steps; empty if none ran while its picture was drawn.
    const std::optional<StepsBeside>& ofLastFrame() const { return ofLastFrame_; }

  private:
    std::unique_ptr<StepThread> thread_;
    std::optional<StepsBeside> ofLastFrame_;
    bool due_ = false;
};

} // namespace meltpool
