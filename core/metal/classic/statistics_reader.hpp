// Statistics over the classic model's particles, summed on the GPU and fetched when they are ready.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/program.hpp"
#include "core/gl/readback.hpp"
#include "core/metal/state/statistics.hpp"

#include <array>
#include <optional>

namespace meltpool {

/// Expects positions, step block and counter of refused states bound as shaders/shared/classic.h says.
class StatisticsReader {
  public:
    StatisticsReader(gl::ShaderLibrary& library, size_t particles);
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
        std::optional<gl::Readback> answer;
        bool asked = false;
    };

    void reduce(const gl::Buffer& refused, const gl::Buffer& target) const;
    /// Of the chunks and the count of refused states behind them.
    MetalStatistics sum(const void* answer) const;

    size_t particles_;
    size_t chunks_;
    const gl::Program& program_;
    std::array<Slot, 3> slots_;
    gl::Buffer waited_; // for now()
    size_t oldest_ = 0;
};

} // namespace meltpool
