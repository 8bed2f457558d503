// Welds attempts one after another without a screen, each into its own folder.
#pragma once

#include "app/activities/replay_end.hpp"
#include "app/commands/headless_runner.hpp"
#include "app/commands/run_folder.hpp"
#include "core/gl/context.hpp"

namespace meltpool {

class AttemptWelder {
  public:
    /// Makes the connection to the graphics driver. Throws InputError where there is none.
    AttemptWelder();

    /// What welds: this program and the graphics driver.
    ReplayMachine machine() const;

    /// Welds the lesson as `run` does, says what came of it and whether it is the recorded attempt, and answers the
    /// figures. A signal stops it after the step. Throws what runHeadless() and requireRoom() throw.
    LessonResult weld(const Lesson& lesson, RunFolder& folder, const RunHooks& hooks = {});

  private:
    gl::HeadlessContext context_;
    gl::ShaderLibrary shaders_;
};

} // namespace meltpool
