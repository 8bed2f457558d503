// Reloads changed shaders while the program runs, and shows why one was refused.
#pragma once

#include "app/session/messages.hpp"
#include "core/gl/context_thread.hpp"
#include "core/gl/program.hpp"

namespace meltpool {

class ShaderWatch {
  public:
    /// Looks at the files twice a second. `other`: a context with programs of its own, or null. `now`: s on the
    /// program's clock. A refused shader's message stays until the shader is mended; its old version stays in use.
    void update(gl::ShaderLibrary& shaders, gl::ContextThread* other, Messages& messages, double now);

  private:
    double next_ = 0; ///< s
};

} // namespace meltpool
