// Plays a lesson on the system's sound device, on a thread of its own. Without a device nothing is heard, and nothing
// else changes.
#pragma once

#include "core/training/feedback/sound/ear.hpp"

#include <glm/vec3.hpp>

#include <atomic>
#include <string>
#include <thread>

namespace meltpool {

class SoundOutput {
  public:
    /// m from the head at which the desk's picture sounds, as far as a welder's head is from the arc.
    static constexpr float kDeskDistance = 0.45F;

    /// Starts the thread, which opens the device; nothing here waits for that. `feed` must outlive this.
    explicit SoundOutput(SoundFeed& feed);
    ~SoundOutput();
    SoundOutput(const SoundOutput&) = delete;
    SoundOutput& operator=(const SoundOutput&) = delete;

    /// From now on the sound comes from this place, m in the directions of the listener's head (x right, y up, z
    /// backwards), with this volume, 0..1. Never waits.
    void update(float volume, const glm::vec3& place);

    /// Whether there is a device is known.
    bool known() const { return state_.load(std::memory_order_acquire) != State::opening; }
    bool plays() const { return state_.load(std::memory_order_acquire) == State::plays; }
    /// What plays, or why nothing does; from known() on.
    std::string sentence() const;

    /// The place of something seen at `eye` (from the eye, its directions) that the desk's picture sounds from.
    static glm::vec3 atDesk(const glm::vec3& eye);

  private:
    enum class State { opening, plays, silent };

    void run();
    void play();

    SoundFeed& feed_;
    std::atomic<State> state_{State::opening};
    std::atomic<bool> ends_{false};
    std::atomic<float> volume_{0}, x_{0}, y_{0}, z_{-1};
    std::string device_, fault_; ///< from known() on: what plays, or why nothing does
    bool headModel_ = false;
    std::thread thread_; ///< last: it uses the others
};

} // namespace meltpool
