// Another OpenGL context, on a thread of its own, that shares nothing with the contexts of other threads.
#pragma once

#include "core/base/function_ref.hpp"

namespace meltpool::gl {

class ShaderLibrary;

class OtherContext {
  public:
    virtual ~OtherContext() = default;
    /// Does `work` on its thread and returns when it is done; throws what it threw. On that thread itself a plain call.
    /// Allocates nothing.
    virtual void run(FunctionRef<void()> work) = 0;
    /// The calling thread is its thread.
    virtual bool here() const = 0;
    /// Its programs, for its thread only.
    virtual ShaderLibrary& shaders() = 0;
};

} // namespace meltpool::gl
