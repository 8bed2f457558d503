// The cost of a running trainer's frame on the processor; with the tests' call counters loaded also its allocations,
// its waits for the GPU, and the graphics driver's share.
#pragma once

#include "core/base/work_meter.hpp"

#include <array>
#include <cstdint>

namespace meltpool {

/// Parts of a frame's processor time.
enum class FrameWork {
    own,     ///< the frame's thread outside the runtime, and outside the driver if call counters separate it
    runtime, ///< calls of the headset's runtime: every call but xrWaitFrame, and the code around them on their thread
    outside, ///< their sum
};
constexpr size_t kFrameWorks = 3;

class FrameMeter {
  public:
    /// Costs of frames so far. All but the number of frames stay 0 without call counters.
    struct Totals {
        unsigned frames = 0;
        unsigned framesThatAllocated = 0;
        std::uint64_t allocations = 0; ///< calls of operator new by our own work
        unsigned stalls = 0;           ///< calls of the frame's thread that wait for the GPU
        const char* lastStall = "";
    };

    void begin();
    /// Excludes the work between these two from the frame, such as writing the telemetry.
    void pause();
    void resume();
    void end();
    /// Adds the costs of another thread's work for this frame.
    void add(const WorkCosts& other);
    /// Resets all sums.
    void restart();

    const Totals& totals() const { return totals_; }
    /// Clock time of the last frame's thread, ms.
    double lastMs(WorkPlace place) const { return last_[static_cast<size_t>(place)]; }
    /// Processor time of the last frame, and of the newest kKept ones, ms.
    double lastMs(FrameWork work) const;
    double medianMs(FrameWork work) const;
    double leastMs(FrameWork work) const;

    static constexpr size_t kKept = 512;

  private:
    using Samples = std::array<float, kKept>;

    void take();
    size_t kept() const;
    const Samples& keptOf(FrameWork work) const { return kept_[static_cast<size_t>(work)]; }

    WorkMeter work_;
    Totals totals_;
    std::array<double, kWorkPlaces> sum_{};
    std::array<double, kWorkPlaces> last_{};
    std::array<double, kFrameWorks> cpu_{};
    std::array<Samples, kFrameWorks> kept_{};
    std::uint64_t allocations_ = 0;
    bool running_ = false;
};

} // namespace meltpool
