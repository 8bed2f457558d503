// Statistics of the classic model's particles: summed on the GPU, read back without waiting.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/program.hpp"
#include "core/gl/readback.hpp"
#include "core/metal/state/statistics.hpp"

#include <optional>

namespace meltpool {

/// Expects positions and step block bound as in shaders/shared/classic.h.
class StatisticsReader {
  public:
    StatisticsReader(gl::ShaderLibrary& library, size_t particles);
    StatisticsReader(const StatisticsReader&) = delete;
    StatisticsReader& operator=(const StatisticsReader&) = delete;

    /// Starts a reduction. `refused` holds one uint: the number of refused states. Throws RuntimeFault if
    /// kStatisticsInFlight are pending.
    void request(const gl::Buffer& refused);
    /// The oldest result that has arrived and was not taken; never waits.
    std::optional<MetalStatistics> poll();
    /// The oldest result that was not taken; waits for the GPU. Nothing only if none is pending.
    std::optional<MetalStatistics> await();
    /// Reduces and waits for the result.
    MetalStatistics now(const gl::Buffer& refused) const;
    /// Discards pending results.
    void discard() { answers_.forget(); }

    size_t bytes() const;

  private:
    void reduce(const gl::Buffer& refused) const;
    /// Statistics from the chunks and the number of refused states behind them.
    MetalStatistics sum(const void* answer) const;

    size_t particles_;
    size_t chunks_;
    const gl::Program& program_;
    gl::Buffer sums_;
    gl::ReadbackQueue answers_;
};

} // namespace meltpool
