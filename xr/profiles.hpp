// Assigns each controller's buttons to actions: the bindings suggested to the runtime, as one table.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace meltpool::xr {

/// Actions of the person. The first three poses and values belong to the action set "weld", the others to "menu".
enum class Action {
    grip,     ///< pose of the hand around the torch
    trigger,  ///< 0..1: heat
    haptic,   ///< output
    aim,      ///< pose of the pointer ray
    squeeze,  ///< 0..1
    menu,     ///< opens and closes the panel
    recentre, ///< brings the workshop in front of the person
    scroll,   ///< thumbstick or trackpad, -1..1 each
};

enum class Sides { both, left, right };

struct SuggestedBinding {
    Action action;
    Sides sides;
    const char* component; ///< below /user/hand/left or right
};

struct InteractionProfile {
    const char* path;
    const char* extension; ///< nullptr: core OpenXR
    std::span<const SuggestedBinding> bindings;
};

/// Every known controller. The tracker has no hands and is bound separately (trackerRoles).
std::span<const InteractionProfile> interactionProfiles();

/// A profile's bindings with both hands written out: {action, hand 0 = left, full path}.
struct HandBinding {
    Action action;
    int hand;
    std::string path;
};
std::vector<HandBinding> handBindings(const InteractionProfile& profile);

constexpr const char* kTrackerProfile = "/interaction_profiles/htc/vive_tracker_htcx";

/// The roles that the runtime's settings may give a tracker on a real torch or filler rod, likeliest first.
std::span<const char* const> trackerRoles();

} // namespace meltpool::xr
