// Writes the recording of an attempt while it runs, without keeping the attempt waiting.
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

/// All calls are of one thread, but checkpoint(). What they bring goes into room that is made at the start; a thread of
/// the writer's own takes it from there to the file, every kPeriod, so that an end without warning loses no more than a
/// little over that time. Nothing but the constructor, wait() and the destructor waits for the disk.
class RecordingWriter {
  public:
    /// How often the file grows.
    static constexpr std::chrono::milliseconds kPeriod{50};
    /// How often it is looked for under its name.
    static constexpr std::chrono::seconds kLook{1};
    /// Room for what waits for the disk: about a minute of steps.
    static constexpr size_t kRoom = size_t(1) << 20;
    /// The same for checkpoints.
    static constexpr size_t kMostWaiting = size_t(64) << 20;

    /// Begins the file with its head. Throws InputError where it is there already or cannot be made there, RuntimeFault
    /// where the machine fails.
    RecordingWriter(const std::filesystem::path& file, const AttemptHead& head);
    /// Writes what was brought, without an end where end() was not called, and waits for it.
    ~RecordingWriter();
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    // These never wait, never fail and allocate nothing. After a fault they do nothing.
    void step(const RecordingStep& step);
    /// What is the same as the last time is not written again.
    void person(const RecordingPerson& person);
    void change(std::uint64_t steps, std::string_view key, std::string_view value);
    /// After `redo` the steps go on from the one after `steps`.
    void event(std::uint64_t steps, std::string_view name, std::string_view value);

    /// `bytes` are whatever restores the state after so many steps. Any thread may call this, before the event `redo`
    /// that takes the attempt back from there. A checkpoint is left out where kMostWaiting bytes of them wait for the
    /// disk: the attempt is whole without.
    void checkpoint(std::uint64_t steps, std::vector<std::byte> bytes);

    /// The score and verdict that end() writes, until others are told; nothing while the weld goes on.
    void judged(std::optional<double> score, std::string verdict);
    /// The attempt has ended: no more calls of the above. Does not wait; the score and verdict in `end` are left out of
    /// account. See finished().
    void end(RecordingEnd end);
    /// The attempt has ended, and nobody knows how.
    void close();

    /// The file is closed, on the disk unless there was a fault().
    bool finished() const { return finished_.load(std::memory_order_acquire); }
    /// Ends as close() does where nobody has ended it, and waits until it is finished.
    void wait();
    /// Why the file is not whole to the attempt's end, as a sentence that names it; empty while nothing failed. What
    /// was written before is whole.
    const std::string& fault() const;

    const std::filesystem::path& file() const { return file_.file(); }
    /// Bytes of the file so far.
    std::uint64_t bytes() const { return bytes_.load(std::memory_order_relaxed); }

  private:
    using Clock = std::chrono::steady_clock;

    struct Checkpoint {
        CheckpointHead head;
        std::vector<std::byte> bytes;
    };

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
    std::atomic<bool> overflowed_{false}; ///< something did not fit, and nothing after it is taken
    std::atomic<bool> failed_{false};     ///< fault_ is set, and stays
    std::atomic<bool> finished_{false};
    std::atomic<std::uint64_t> bytes_{0};
    std::string fault_;

    std::atomic<std::uint32_t> redone_{0}; ///< times that the attempt went back

    std::mutex mutex_; ///< of the next four
    std::condition_variable changed_;
    bool closing_ = false;
    std::vector<Checkpoint> checkpoints_;
    size_t waiting_ = 0; ///< bytes of checkpoints_

    bool ended_ = false; ///< end() or close() was called
    std::optional<double> score_;
    std::string verdict_;
    RecordingPerson person_; ///< the last one
    bool personKnown_ = false;

    std::string batch_;      ///< of the writing thread: sealed frames
    std::string content_;    ///< of the writing thread
    Clock::time_point look_; ///< of the writing thread: when it looks for the file again
    std::thread thread_;     ///< last: everything else is there before it runs
};

} // namespace meltpool
