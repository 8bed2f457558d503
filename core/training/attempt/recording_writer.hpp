// Writes the recording of a running attempt without making the attempt wait.
#pragma once

#include "core/training/attempt/content.hpp"
#include "core/training/attempt/frame.hpp"
#include "core/training/attempt/frame_ring.hpp"
#include "core/training/attempt/growing_file.hpp"
#include "core/training/attempt/recording.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace meltpool {

/// One thread makes all calls, except checkpoint(). The calls fill a ring of fixed size; a writing thread moves it to
/// the file every kPeriod, so that a sudden end loses little more than that time. Only the constructor, wait() and the
/// destructor wait for the disk.
class RecordingWriter {
  public:
    /// Period in which the file grows.
    static constexpr std::chrono::milliseconds kPeriod{50};
    /// Period of the check that the file has its name.
    static constexpr std::chrono::seconds kLook{1};
    /// Bytes that may wait for the disk: about a minute of steps.
    static constexpr size_t kRoom = size_t(1) << 20;
    /// Bytes of checkpoints that may wait for the disk.
    static constexpr size_t kMostWaiting = size_t(64) << 20;

    /// Creates the file and writes its head. Throws InputError if it exists already or cannot be created there,
    /// RuntimeFault if the machine fails.
    /// `begin`: a finished recording whose steps, notes and checkpoints are this one's first ones; empty: none. Throws
    /// InputError, too, if it is not whole.
    RecordingWriter(const std::filesystem::path& file, const AttemptHead& head,
                    const std::filesystem::path& begin = {});
    /// Writes everything received and waits for it; without end() the file has no end.
    ~RecordingWriter();
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    // These never wait, never fail and allocate nothing. After a fault they are no-ops.
    void step(const RecordingStep& step);
    /// Writes only the parts that changed since the last call.
    void person(const RecordingPerson& person);
    void change(std::uint64_t steps, std::string_view key, std::string_view value);
    /// After `redo` the steps continue from the one after `steps`.
    void event(std::uint64_t steps, std::string_view name, std::string_view value);

    /// `bytes` restore the state after so many steps. Any thread may call this, before the event `redo` that takes the
    /// attempt back from there. A checkpoint is dropped if kMostWaiting bytes of them wait for the disk: the recording
    /// is complete without it.
    void checkpoint(std::uint64_t steps, std::vector<std::byte> bytes);

    /// Sets the score and verdict that end() writes, until the next call; empty while the weld goes on.
    void judged(std::optional<double> score, std::string verdict);
    /// Ends the attempt: no more calls of the above. Does not wait; the score and verdict in `end` are ignored. See
    /// finished().
    void end(RecordingEnd end);
    /// Ends the attempt without a recorded end.
    void close();

    /// True once the file is closed, and on the disk unless there was a fault().
    bool finished() const { return finished_.load(std::memory_order_acquire); }
    /// Ends as close() does unless it has ended, and waits until it is finished.
    void wait();
    /// Reason why the file is not whole to the attempt's end, as a sentence that names the file; empty without a fault.
    /// Everything written before is whole.
    const std::string& fault() const;

    const std::filesystem::path& file() const { return file_.file(); }
    /// Size of the file so far, in bytes.
    std::uint64_t bytes() const { return bytes_.load(std::memory_order_relaxed); }

  private:
    using Clock = std::chrono::steady_clock;

    struct Checkpoint {
        CheckpointHead head;
        std::vector<std::byte> bytes;
    };

    void copy(const std::filesystem::path& begin);
    void put(FrameKind kind, std::initializer_list<std::string_view> parts);
    void run();
    void gather();
    void appendCheckpoints(const std::vector<Checkpoint>& checkpoints);
    bool write();
    bool lookForFile(bool now);
    void fail(std::string sentence);

    GrowingFile file_;
    FrameChain chain_;
    FrameRing ring_{kRoom};
    std::atomic<bool> overflowed_{false}; ///< a frame did not fit; later ones are not taken
    std::atomic<bool> failed_{false};     ///< fault_ is set and does not change
    std::atomic<bool> finished_{false};
    std::atomic<std::uint64_t> bytes_{0};
    std::string fault_;

    std::atomic<std::uint32_t> redone_{0}; ///< times that the attempt went back

    std::mutex mutex_; ///< guards the next four
    std::condition_variable changed_;
    bool closing_ = false;
    std::vector<Checkpoint> checkpoints_;
    size_t waiting_ = 0; ///< bytes of checkpoints_

    bool ended_ = false; ///< true after end() or close()
    std::optional<double> score_;
    std::string verdict_;
    RecordingPerson person_; ///< last written pose
    bool personKnown_ = false;

    std::string batch_;      ///< sealed frames, of the writing thread
    std::string content_;    ///< buffer of the writing thread
    Clock::time_point look_; ///< next time to look for the file, of the writing thread
    std::thread thread_;     ///< last: its run() uses every other member
};

} // namespace meltpool
