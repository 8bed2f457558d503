// The particles of another context, copied into buffers of the calling thread's, for surfaces and pictures there.
#pragma once

#include "core/gl/other_context.hpp"
#include "core/metal/state/particle_view.hpp"

#include <array>
#include <cstddef>

namespace meltpool {

class ParticleMirror {
  public:
    /// Copies what `original` shows of `there`, whose buffers must be in memory that any thread reads
    /// (gl::directMemory()). Nothing may be under way there.
    void take(const ParticleView& original, gl::OtherContext& there);
    /// As of the last take().
    const ParticleView& view() const { return view_; }
    size_t bytes() const;

  private:
    static constexpr size_t kBuffers = 6;

    const gl::Buffer* copy(size_t number, const gl::Buffer* original, const std::byte* memory, size_t bytes);

    std::array<gl::Buffer, kBuffers> buffers_;
    ParticleView view_;
};

} // namespace meltpool
