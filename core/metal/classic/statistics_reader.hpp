// Statistics over the classic model's particles, summed on the GPU and fetched when they are ready.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/program.hpp"
#include "core/metal/statistics.hpp"

#include <array>
#include <optional>

namespace meltpool {

/// Expects positions, step block and counter of refused states bound as shaders/shared/classic.h says.
class StatisticsReader {
  public:
    StatisticsReader(gl::ShaderLibrary& library, size_t particles);
    ~StatisticsReader();
    StatisticsReader(const StatisticsReader&) = delete;
    StatisticsReader& operator=(const StatisticsReader&) = delete;

    /// Starts a reduction; dropped while all slots are on their way. `refused` holds one uint.
    void request(const gl::Buffer& refused);
    /// The newest that arrived since the last call; never waits.
    std::optional<MetalStatistics> poll();
    /// A reduction now, waited for.
    MetalStatistics now(const gl::Buffer& refused) const;
    /// Drops what is on its way.
    void forget();

    size_t bytes() const;

  private:
    struct Slot {
        gl::Buffer buffer;
        GLsync fence = nullptr;
    };

    void reduce(const gl::Buffer& refused, const gl::Buffer& target) const;
    MetalStatistics read(const gl::Buffer& buffer) const;

    size_t particles_;
    size_t chunks_;
    const gl::Program& program_;
    std::array<Slot, 4> slots_; // the last one is for now()
    size_t oldest_ = 0;
};

} // namespace meltpool
