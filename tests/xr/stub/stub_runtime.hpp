// Imitates an OpenXR runtime inside the test program, without headset and compositor, behind the loader's functions.
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
    /// Makes every call of a frame hang from now on, until goOn().
    void hang();
    void goOn();
    /// Makes each wait for a frame take longer than a front end's patience from now on, until so many frames with
    /// pictures were ended: a runtime that paces the frames by the duration of the last ones.
    void paceSlowly(int pictures) { slowFrames_ = pictures; }
    int slowFrames() const { return slowFrames_; }
    /// Makes every such call return XR_ERROR_INSTANCE_LOST from now on, until a new instance exists.
    void loseInstance() { lost_ = true; }

    /// Number of ended frames, of existing instances, of calls that hang now.
    int frames() const { return frames_; }
    int instances() const { return instances_; }
    int hanging() const { return hanging_; }

    // Calls for the functions of the API.
    XrResult call(); ///< hangs or fails on request
    void changeState(XrSessionState state);
    bool takeEvent(XrEventDataBuffer& event);
    void onInstance(int change);
    void onFrame(bool pictures);

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool hangs_ = false;
    std::deque<XrSessionState> states_; ///< changes not yet reported by an event
    std::atomic<bool> lost_ = false;
    std::atomic<int> frames_ = 0;
    std::atomic<int> instances_ = 0;
    std::atomic<int> hanging_ = 0;
    std::atomic<int> slowFrames_ = 0;
};

StubRuntime& stubRuntime();

} // namespace meltpool::test
