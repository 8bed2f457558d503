// A copy of another context's particles in buffers of the calling thread, for surfaces and pictures there.
#pragma once

#include "core/gl/context_thread.hpp"
#include "core/metal/state/particle_view.hpp"

#include <array>
#include <cstddef>

namespace meltpool {

class ParticleMirror {
  public:
    /// Copies the buffers of `original` from `there`; they must be in memory that any thread reads
    /// (gl::directMemory()). No work may be under way there.
    void take(const ParticleView& original, gl::ContextThread& there);
    /// The particles of the last take().
    const ParticleView& view() const { return view_; }
    size_t bytes() const;

  private:
    static constexpr size_t kBuffers = 6;

    const gl::Buffer* copy(size_t number, const gl::Buffer* original, const std::byte* memory, size_t bytes);

    std::array<gl::Buffer, kBuffers> buffers_;
    ParticleView view_;
};

} // namespace meltpool
