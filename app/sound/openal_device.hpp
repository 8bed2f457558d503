// A sound device with one source in space, through OpenAL Soft and its model of the head.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace meltpool {

/// Sound device. The listener is at the origin and looks along -z, y is up. One thread at a time may use a device,
/// except place() and volume(), which any may.
class OpenAlDevice {
  public:
    static constexpr int kRate = 48000;               ///< samples per second
    static constexpr size_t kBlock = kRate / 100;     ///< samples queued at once: 10 ms
    static constexpr size_t kBlocks = 4;              ///< in the queue: one that plays, and a reserve for a late thread
    static constexpr float kReferenceDistance = 0.5F; ///< m; closer the volume is constant, farther off it falls as 1/r

    /// Stops the library from writing to standard error; sets its variable ALSOFT_LOGLEVEL unless it is set. Call it at
    /// the program's beginning, before other threads start.
    static void quietLibrary();

    /// Opens the device that the system plays on. Throws RuntimeFault with a sentence if there is none. May take long:
    /// sound servers are asked.
    static std::unique_ptr<OpenAlDevice> openDefault();
    /// Opens no device: render() returns the samples that one would play. Throws RuntimeFault if the library cannot.
    static std::unique_ptr<OpenAlDevice> openLoopback();
    ~OpenAlDevice();
    OpenAlDevice(const OpenAlDevice&) = delete;
    OpenAlDevice& operator=(const OpenAlDevice&) = delete;

    /// Name of the device: "Built-in Audio".
    const std::string& name() const { return name_; }
    /// True if the sound at both ears is filtered as by a head.
    bool hasHeadModel() const { return headModel_; }

    void place(const glm::vec3& metres);
    void volume(float factor);

    /// Count of blocks that the queue takes now. After an underrun it takes all of them before it plays again.
    size_t room();
    /// Queues kBlock samples of one channel, and plays.
    void queue(std::span<const std::int16_t> samples);
    /// Renders a loopback device's next frames, left and right in turn.
    void render(std::span<std::int16_t> leftAndRight);

  private:
    struct Handles; ///< handles of the library, whose headers only the implementation includes

    explicit OpenAlDevice(std::unique_ptr<Handles> handles);
    void open(const int* attributes);

    std::unique_ptr<Handles> handles_;
    unsigned source_ = 0;
    std::uint32_t buffers_[kBlocks] = {};
    size_t queued_ = 0; ///< buffers that have been queued at least once, up to kBlocks
    std::string name_;
    bool headModel_ = false;
};

} // namespace meltpool
