// A sound device with one source in space, through OpenAL Soft and its model of the head.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace meltpool {

/// The listener stands at the origin and looks along -z, y is up. One thread at a time may use a device, except
/// place() and volume(), which any may.
class OpenAlDevice {
  public:
    static constexpr int kRate = 48000;               ///< samples a second
    static constexpr size_t kBlock = kRate / 100;     ///< samples that are queued at once: 10 ms
    static constexpr size_t kBlocks = 4;              ///< in the queue: one that plays, and what a late thread may miss
    static constexpr float kReferenceDistance = 0.5F; ///< m; nearer it is no louder, farther off it fades as 1/r

    /// Keeps the library from writing to standard error; sets its variable ALSOFT_LOGLEVEL where it is not set, so it
    /// is for the program's beginning, before other threads.
    static void quietLibrary();

    /// The device that the system plays on. Throws RuntimeFault with a sentence where there is none. May take long:
    /// sound servers are asked.
    static std::unique_ptr<OpenAlDevice> openDefault();
    /// No device: render() gives what one would play. Throws RuntimeFault where the library cannot.
    static std::unique_ptr<OpenAlDevice> openLoopback();
    ~OpenAlDevice();
    OpenAlDevice(const OpenAlDevice&) = delete;
    OpenAlDevice& operator=(const OpenAlDevice&) = delete;

    /// "Built-in Audio".
    const std::string& name() const { return name_; }
    /// Both ears get what a head would let them hear.
    bool hasHeadModel() const { return headModel_; }

    void place(const glm::vec3& metres);
    void volume(float factor);

    /// Blocks that the queue takes now. A queue that ran empty takes all of them before it plays again.
    size_t room();
    /// Queues kBlock samples of one channel, and plays.
    void queue(std::span<const std::int16_t> samples);
    /// Of a loopback device: the next frames of what is heard, left and right in turn.
    void render(std::span<std::int16_t> leftAndRight);

  private:
    struct Handles; ///< of the library, whose headers are not for everybody

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
