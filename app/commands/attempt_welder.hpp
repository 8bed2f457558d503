// Welds attempts one after another without a screen, each into its own folder.
#pragma once

#include "app/activities/replay_end.hpp"
#include "app/commands/headless_runner.hpp"
#include "app/commands/run_folder.hpp"
#include "core/gl/context.hpp"

namespace meltpool {

class AttemptWelder {
  public:
    /// Connects to the graphics driver. Throws InputError if there is none.
    AttemptWelder();

    /// Machine that welds: this program and the graphics driver.
    ReplayMachine machine() const;

    /// Welds the lesson as `run` does, prints the result and the comparison with the recorded attempt, and returns the
    /// figures. A signal stops it after the step. Throws whatever runHeadless() and requireCapacity() throw.
    LessonResult weld(const Lesson& lesson, RunFolder& folder, const RunHooks& hooks = {});

  private:
    gl::HeadlessContext context_;
    gl::ShaderLibrary shaders_;
};

} // namespace meltpool
