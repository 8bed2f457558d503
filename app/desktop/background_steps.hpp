// The metal's steps on a thread of their own, made while the window's thread draws the frame's picture.
#pragma once

#include "app/desktop/step_thread.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace meltpool {

/// Steps made on another thread beside a picture, s.
struct StepsBeside {
    double seconds = 0; ///< from their begin until picture and steps were done
    double waited = 0;  ///< of that, after the picture
};

/// A frame calls postpone() where it has steps for the thread, begin() before it draws and finish() after.
class BackgroundSteps {
  public:
    /// There is a thread only where the processor draws: a card works beside the processor anyway. `shaders`: the
    /// folder of its shaders.
    explicit BackgroundSteps(const std::filesystem::path& shaders);

    /// Null: there is none.
    StepThread* thread() { return thread_.get(); }
    bool possible() const { return thread_ != nullptr; }

    /// Time that steps may take beside a picture, s: the last frame's without its waiting for steps.
    double timeBeside(double lastFrameSeconds) const;
    /// This frame's steps wait for its picture. Only where a thread is possible().
    void postpone() { due_ = true; }
    /// Steps are postponed and not yet finished.
    bool due() const { return due_; }
    /// Begins the postponed steps, which `work` makes on the thread; no-op where none are due.
    void begin(std::function<void()> work);
    /// Waits until the steps are made; throws what `work` threw. False where none were due.
    bool finish();
    /// Waits for steps under way when the program ends; their fault goes to standard error.
    void abandon();

    /// The steps of the last frame; empty: none were made beside its picture.
    const std::optional<StepsBeside>& ofLastFrame() const { return ofLastFrame_; }

  private:
    std::unique_ptr<StepThread> thread_;
    std::optional<StepsBeside> ofLastFrame_;
    bool due_ = false;
};

} // namespace meltpool
