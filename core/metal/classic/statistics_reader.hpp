// Statistics of the classic model's particles: summed on the GPU, read back without waiting.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/program.hpp"
#include "core/gl/readback.hpp"
#include "core/metal/state/statistics.hpp"

#include <array>
#include <optional>

namespace meltpool {

/// Expects positions and step block bound as in shaders/shared/classic.h.
class StatisticsReader {
  public:
    StatisticsReader(gl::ShaderLibrary& library, size_t particles);
    StatisticsReader(const StatisticsReader&) = delete;
    StatisticsReader& operator=(const StatisticsReader&) = delete;

    /// Starts a reduction, unless all slots are pending. `refused` holds one uint: the number of refused states.
    void request(const gl::Buffer& refused);
    /// The newest that arrived since the last call; never waits.
    std::optional<MetalStatistics> poll();
    /// Reduces and waits for the result.
    MetalStatistics now(const gl::Buffer& refused) const;
    /// Discards pending results.
    void discard();

    size_t bytes() const;

  private:
    struct Slot {
        gl::Buffer buffer;
        std::optional<gl::Readback> answer;
        bool pending = false;
    };

    void reduce(const gl::Buffer& refused, const gl::Buffer& target) const;
    /// Statistics from the chunks and the number of refused states behind them.
    MetalStatistics sum(const void* answer) const;

    size_t particles_;
    size_t chunks_;
    const gl::Program& program_;
    std::array<Slot, 3> slots_;
    gl::Buffer waited_; // for now()
    size_t oldest_ = 0;
};

} // namespace meltpool
