// An OpenXR runtime inside the test program, without headset and compositor: what the loader's functions would call.
// Its calls can be made to hang and to fail, from any thread.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>

#include "xr/platform.hpp"

namespace meltpool::test {

class StubRuntime {
  public:
    /// From now on every call that a frame makes hangs, until goOn().
    void hang();
    void goOn();
    /// From now on each wait for a frame takes longer than a front end has patience, until so many frames with pictures
    /// were ended: a runtime that paces the frames by how long the last ones took.
    void paceSlowly(int pictures) { slowFrames_ = pictures; }
    int slowFrames() const { return slowFrames_; }
    /// From now on every such call answers XR_ERROR_INSTANCE_LOST, until an instance is made anew.
    void loseInstance() { lost_ = true; }

    /// How many frames were ended, how many instances exist, how many calls hang now.
    int frames() const { return frames_; }
    int instances() const { return instances_; }
    int hanging() const { return hanging_; }

    // For the functions of the API.
    XrResult call(); ///< hangs or fails where it was told to
    void changeState(XrSessionState state);
    bool takeEvent(XrEventDataBuffer& event);
    void onInstance(int change);
    void onFrame(bool pictures);

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool hangs_ = false;
    std::deque<XrSessionState> states_; ///< changes that no event has told yet
    std::atomic<bool> lost_ = false;
    std::atomic<int> frames_ = 0;
    std::atomic<int> instances_ = 0;
    std::atomic<int> hanging_ = 0;
    std::atomic<int> slowFrames_ = 0;
};

StubRuntime& stubRuntime();

} // namespace meltpool::test
