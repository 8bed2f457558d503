// An OpenGL context on a thread of its own that shares nothing with other contexts.
#pragma once

#include "core/base/function_ref.hpp"

namespace meltpool::gl {

class ShaderLibrary;

class ContextThread {
  public:
    virtual ~ContextThread() = default;
    /// Runs `work` on the context's thread and returns when it is done; rethrows its exceptions. A plain call on that
    /// thread itself. Allocates nothing.
    virtual void run(FunctionRef<void()> work) = 0;
    /// True on the context's thread.
    virtual bool here() const = 0;
    /// The context's programs, for its thread only.
    virtual ShaderLibrary& shaders() = 0;
};

} // namespace meltpool::gl
