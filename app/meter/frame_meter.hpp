// What a frame of the running trainer costs the processor: its own work beside driver and runtime, what it asks of the
// heap, and whether it ever stands still for the GPU.
#pragma once

#include "core/base/work_meter.hpp"

#include <array>
#include <cstdint>

namespace meltpool {

class FrameMeter {
  public:
    /// Costs of frames so far.
    struct Totals {
        unsigned frames = 0;
        unsigned framesThatAllocated = 0;
        std::uint64_t allocations = 0; ///< calls of operator new by our own work
        unsigned stalls = 0;           ///< calls that wait for the GPU
        const char* lastStall = "";
    };

    void begin();
    /// What happens between these is not the frame's: writing down what it cost.
    void pause();
    void resume();
    void end();
    /// Forgets the frames so far.
    void restart();

    const Totals& totals() const { return totals_; }
    /// Of the last frame, ms: of the clock, and for own work the processor's time.
    double lastMs(WorkPlace place) const { return last_[static_cast<size_t>(place)]; }
    /// The processor's time for own work in the newest kKept frames, ms.
    double medianOwnMs() const;
    double leastOwnMs() const;

    static constexpr size_t kKept = 512;

  private:
    void take();

    WorkMeter work_;
    Totals totals_;
    std::array<double, kWorkPlaces> sum_{};
    std::array<double, kWorkPlaces> last_{};
    std::array<float, kKept> own_{};
    std::uint64_t allocations_ = 0;
    bool running_ = false;
};

} // namespace meltpool
