// Reads poses and buttons of controllers and trackers, and plays vibration.
#pragma once

#include "xr/haptic_pulse.hpp"
#include "xr/profiles.hpp"
#include "xr/session.hpp"

#include <array>
#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meltpool::xr {

enum class Hand { left = 0, right = 1 };

/// One hand in one frame.
struct HandInput {
    bool present = false;  ///< a controller is switched on and bound
    bool tracked = false;  ///< the pose is measured in this frame; else `grip` is the last known one
    Pose grip;             ///< pose in the session's space
    Pose aim;              ///< ray along -Z
    Pose hold;             ///< pose of a held tool: place of the grip, along the aim if the grip leans far from it
    float trigger = 0;     ///< 0..1
    float squeeze = 0;     ///< 0..1
    bool menu = false;     ///< pressed since the last frame
    bool recentre = false; ///< held down now
    float scrollX = 0;     ///< -1..1
    float scrollY = 0;
};

/// A tracker fixed to a real torch or filler rod.
struct TrackerInput {
    std::string role; ///< "handheld_object"
    bool tracked = false;
    Pose pose;
    float trigger = 0; ///< 0..1, from a switch wired to its pins
};

/// The action sets "weld" and "menu" with suggestions for every known controller.
class Input {
  public:
    /// Makes the actions and attaches them; call it once a session. Throws XrFault.
    explicit Input(const Session& session);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    /// Reads all actions, and the poses predicted for `time`. Hands are absent while the session has no focus.
    void read(XrTime time);
    const HandInput& hand(Hand which) const { return hands_[size_t(which)]; }
    const std::array<HandInput, 2>& hands() const { return hands_; } ///< in the order of Hand
    const std::vector<TrackerInput>& trackers() const { return trackers_; }

    /// Chooses each hand's hold by its next tracked poses: it may have another controller.
    void onProfileChanged() { holds_ = {}; }
    /// True if a tool in this hand follows the aim, false if it follows the grip; empty before both were tracked.
    std::optional<bool> holdsByAim(Hand which) const;

    /// Plays the pulse; a silent one stops the vibration. At most once a hand and frame.
    void play(Hand which, const HapticPulse& pulse);
    /// Plays the pulse on the device wired to a tracker's pins; a no-op if none is bound.
    void playTracker(size_t which, const HapticPulse& pulse);
    /// Counts of starts and stops of the runtime's vibration.
    struct HapticCalls {
        unsigned applied = 0;
        unsigned stopped = 0;
    };
    const HapticCalls& hapticCalls() const { return hapticCalls_; }

    /// The profile that the runtime has bound to a hand; empty: none.
    std::string profile(Hand which) const;
    /// Profiles whose suggested bindings the runtime refused, with its answer, for `meltpool doctor`.
    const std::vector<std::string>& refused() const { return refused_; }

  private:
    /// The sine that a PCM device plays, continued from pulse to pulse.
    struct Wave {
        double phase = 0;
        double frequency = 0;
        std::chrono::steady_clock::time_point start;
    };

    struct Actions {
        XrAction grip = XR_NULL_HANDLE, trigger = XR_NULL_HANDLE, haptic = XR_NULL_HANDLE, aim = XR_NULL_HANDLE,
                 squeeze = XR_NULL_HANDLE, menu = XR_NULL_HANDLE, recentre = XR_NULL_HANDLE, scroll = XR_NULL_HANDLE,
                 tracker = XR_NULL_HANDLE, trackerTrigger = XR_NULL_HANDLE, trackerHaptic = XR_NULL_HANDLE;
    };

    /// One vibrating device.
    struct HapticOutput {
        bool vibrating = false;
        Wave wave;
    };

    /// A hand's choice of the tool's direction. Grip and aim are rigid to each other, so it is made once.
    struct Hold {
        bool byAim = false;
        glm::quat fromGrip{1, 0, 0, 0};
    };

    void makeActions();
    void makeTrackerActions();
    void suggest();
    void suggestTrackers();
    void attach();
    void makeSpaces();
    XrAction makeAction(XrActionSet set, XrActionType type, const char* name, const char* label,
                        std::span<const XrPath> paths);
    XrAction actionOf(Action action) const;
    void readHand(size_t hand, XrTime time);
    void locateHand(size_t hand, XrTime time);
    void forget();
    float readFloat(XrAction action, XrPath hand) const;
    bool wentDown(XrAction action, XrPath hand) const;
    bool isDown(XrAction action, XrPath hand) const;
    void playOn(HapticOutput& output, const XrHapticActionInfo& target, const HapticPulse& pulse);
    bool playPcm(Wave& wave, const XrHapticActionInfo& target, const HapticPulse& pulse);

    const Session& session_;
    const Instance& instance_;
    XrActionSet weld_ = XR_NULL_HANDLE;
    XrActionSet menu_ = XR_NULL_HANDLE;
    Actions actions_;
    std::array<XrPath, 2> handPaths_{};
    std::array<XrSpace, 2> gripSpaces_{};
    std::array<XrSpace, 2> aimSpaces_{};
    std::array<HandInput, 2> hands_;
    std::array<std::optional<Hold>, 2> holds_;
    std::array<HapticOutput, 2> handOutputs_{};
    std::vector<HapticOutput> trackerOutputs_;
    std::vector<XrPath> rolePaths_;
    std::vector<XrSpace> roleSpaces_;
    std::vector<TrackerInput> trackers_;
    std::vector<std::string> refused_;
    HapticCalls hapticCalls_;
};

} // namespace meltpool::xr
