// What a frame of the running trainer costs the processor. With the tests' call counters loaded also how often it
// allocates and waits for the GPU, and the graphics driver's share.
#pragma once

#include "core/base/work_meter.hpp"

#include <array>
#include <cstdint>

namespace meltpool {

/// The processor's time of a frame for ...
enum class FrameWork {
    own,     ///< the frame's thread outside the runtime, and outside the driver where call counters tell it apart
    runtime, ///< calling the headset's runtime: every call but xrWaitFrame, and what stands around them on their thread
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
    /// Work between these two does not count as the frame's, such as writing the telemetry.
    void pause();
    void resume();
    void end();
    /// Adds what another thread did for this frame.
    void add(const WorkCosts& other);
    /// Forgets the frames so far.
    void restart();

    const Totals& totals() const { return totals_; }
    /// Of the last frame's thread, ms of the clock.
    double lastMs(WorkPlace place) const { return last_[static_cast<size_t>(place)]; }
    /// The processor's time of the last frame, and of the newest kKept ones, ms.
    double lastMs(FrameWork work) const;
    double medianMs(FrameWork work) const;
    double leastMs(FrameWork work) const;

    static constexpr size_t kKept = 512;

  private:
    using Kept = std::array<float, kKept>;

    void take();
    size_t kept() const;
    const Kept& keptOf(FrameWork work) const { return kept_[static_cast<size_t>(work)]; }

    WorkMeter work_;
    Totals totals_;
    std::array<double, kWorkPlaces> sum_{};
    std::array<double, kWorkPlaces> last_{};
    std::array<double, kFrameWorks> cpu_{};
    std::array<Kept, kFrameWorks> kept_{};
    std::uint64_t allocations_ = 0;
    bool running_ = false;
};

} // namespace meltpool
