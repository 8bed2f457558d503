// Imitates an OpenXR runtime inside the test program, without headset and compositor, behind the loader's functions.
// Its calls can be made to hang and to fail, from any thread.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "xr/newer_openxr.hpp"
#include "xr/platform.hpp"

namespace meltpool::test {

/// Properties of the imitated headset. Change them while no instance exists, or by changeController().
struct StubDevice {
    std::vector<std::string> withheld; ///< extensions that are not offered
    bool presence = true;              ///< has a sensor for the head
    bool stage = true;                 ///< offers STAGE
    float lean = 0;                    ///< radians that the aim points above the grip
    float hidden = 0;                  ///< width of a hidden strip at the left of both eyes, in the plane z = -1
    std::vector<float> rates{72, 120, 90, 80}; ///< display rates, Hz
};

/// A layer of a submitted frame.
struct StubLayer {
    XrStructureType type = XR_TYPE_UNKNOWN;
    bool tested = false; ///< has a depth test
    bool writesDepth = false;
    XrCompareOpFB compare = XR_COMPARE_OP_ALWAYS_FB;
};

class StubRuntime {
  public:
    StubDevice device() const;
    void setDevice(const StubDevice& device);
    /// Events of the runtime.
    void moveSpace(XrReferenceSpaceType type, XrTime at);
    void wear(bool worn);
    /// Puts a controller into the hand whose aim points `lean` radians above its grip.
    void changeController(float lean);
    void changeMask(float hidden);
    void changeState(XrSessionState state);

    /// Requests and submissions of the program.
    float requestedRate() const;
    int sustainedProcessors() const;
    std::vector<StubLayer> layers() const; ///< layers of the last frame that had some

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
    bool takeEvent(XrEventDataBuffer& event);
    void onInstance(int change);
    void onEnabled(std::vector<std::string> extensions);
    bool enabled(const std::string& extension) const;
    void onAction(XrAction action, const char* name);
    void onActionSpace(XrSpace space, XrAction action);
    XrPosef pose(XrSpace space) const;
    void onRate(float rate);
    void onSustained();
    void onFrame(const XrFrameEndInfo& frame);

  private:
    template <class Event>
    void send(const Event& event);

    mutable std::mutex mutex_;
    StubDevice device_;
    std::vector<std::string> enabled_;
    std::map<XrAction, std::string> actions_;
    std::map<XrSpace, std::string> actionSpaces_;
    std::vector<StubLayer> layers_;
    float requestedRate_ = 0;
    int sustained_ = 0;
    std::condition_variable changed_;
    bool hangs_ = false;
    std::deque<XrEventDataBuffer> events_; ///< events not yet polled
    std::atomic<bool> lost_ = false;
    std::atomic<int> frames_ = 0;
    std::atomic<int> instances_ = 0;
    std::atomic<int> hanging_ = 0;
    std::atomic<int> slowFrames_ = 0;
};

StubRuntime& stubRuntime();

} // namespace meltpool::test
