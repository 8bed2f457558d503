// The sound of a lesson on the system's device, on a thread of its own. Without a device it is silent, and nothing else
// changes.
#pragma once

#include "core/training/feedback/sound/sound_steps.hpp"

#include <glm/vec3.hpp>

#include <atomic>
#include <string>
#include <thread>

namespace meltpool {

class SoundOutput {
  public:
    /// m from the head to the sound of the desk's picture: a welder's distance from the arc.
    static constexpr float kDeskDistance = 0.45F;

    /// Starts the thread, which opens the device without blocking the caller. `feed` must outlive this.
    explicit SoundOutput(SoundFeed& feed);
    ~SoundOutput();
    SoundOutput(const SoundOutput&) = delete;
    SoundOutput& operator=(const SoundOutput&) = delete;

    /// Moves the sound to this place, m in the directions of the listener's head (x right, y up, z backwards), with
    /// this volume, 0..1. Never waits.
    void update(float volume, const glm::vec3& place);

    /// True once the search for a device has ended.
    bool known() const { return state_.load(std::memory_order_acquire) != State::opening; }
    bool plays() const { return state_.load(std::memory_order_acquire) == State::plays; }
    /// Sentence about the device that plays, or the reason why none does; from known() on.
    std::string sentence() const;

    /// Place of the sound for something seen at `eye` (from the eye, in its directions) on the desk's picture.
    static glm::vec3 atDesk(const glm::vec3& eye);

  private:
    enum class State { opening, plays, silent };

    void run();
    void play();

    SoundFeed& feed_;
    std::atomic<State> state_{State::opening};
    std::atomic<bool> ends_{false};
    std::atomic<float> volume_{0}, x_{0}, y_{0}, z_{-1};
    std::string device_, fault_; ///< from known() on: the playing device, or the reason why none plays
    bool headModel_ = false;
    std::thread thread_; ///< last: it uses the others
};

} // namespace meltpool
