// Makes the action sets, suggests bindings and reads the actions once a frame.
#include "xr/input.hpp"

#include <cstring>

namespace meltpool::xr {

namespace {

XrActionSet makeSet(XrInstance instance, const char* name, const char* label) {
    XrActionSetCreateInfo info{XR_TYPE_ACTION_SET_CREATE_INFO};
    std::strncpy(info.actionSetName, name, XR_MAX_ACTION_SET_NAME_SIZE - 1);
    std::strncpy(info.localizedActionSetName, label, XR_MAX_LOCALIZED_ACTION_SET_NAME_SIZE - 1);
    XrActionSet set = XR_NULL_HANDLE;
    MELTPOOL_XR(xrCreateActionSet(instance, &info, &set));
    return set;
}

XrActionStateGetInfo ask(XrAction action, XrPath hand) {
    XrActionStateGetInfo get{XR_TYPE_ACTION_STATE_GET_INFO};
    get.action = action;
    get.subactionPath = hand;
    return get;
}

} // namespace

Input::Input(const Session& session) : session_(session), instance_(session.instance()) {
    handPaths_ = {instance_.path("/user/hand/left"), instance_.path("/user/hand/right")};
    weld_ = makeSet(instance_.handle(), "weld", "Welding");
    menu_ = makeSet(instance_.handle(), "menu", "Menus");
    makeActions();
    if (instance_.has("XR_HTCX_vive_tracker_interaction")) makeTrackerActions();
    suggest();
    suggestTrackers();
    attach();
    makeSpaces();
}

Input::~Input() {
    for (const XrSpace space : gripSpaces_)
        xrDestroySpace(space);
    for (const XrSpace space : aimSpaces_)
        xrDestroySpace(space);
    for (const XrSpace space : roleSpaces_)
        xrDestroySpace(space);
    xrDestroyActionSet(weld_);
    xrDestroyActionSet(menu_);
}

XrAction Input::makeAction(XrActionSet set, XrActionType type, const char* name, const char* label,
                           std::span<const XrPath> paths) {
    XrActionCreateInfo info{XR_TYPE_ACTION_CREATE_INFO};
    info.actionType = type;
    std::strncpy(info.actionName, name, XR_MAX_ACTION_NAME_SIZE - 1);
    std::strncpy(info.localizedActionName, label, XR_MAX_LOCALIZED_ACTION_NAME_SIZE - 1);
    info.countSubactionPaths = uint32_t(paths.size());
    info.subactionPaths = paths.data();
    XrAction action = XR_NULL_HANDLE;
    MELTPOOL_XR(xrCreateAction(set, &info, &action));
    return action;
}

void Input::makeActions() {
    actions_.grip = makeAction(weld_, XR_ACTION_TYPE_POSE_INPUT, "grip", "Torch in the hand", handPaths_);
    actions_.trigger = makeAction(weld_, XR_ACTION_TYPE_FLOAT_INPUT, "trigger", "Heat", handPaths_);
    actions_.haptic = makeAction(weld_, XR_ACTION_TYPE_VIBRATION_OUTPUT, "feel", "Vibration of the torch", handPaths_);
    actions_.aim = makeAction(menu_, XR_ACTION_TYPE_POSE_INPUT, "aim", "Pointer", handPaths_);
    actions_.squeeze = makeAction(menu_, XR_ACTION_TYPE_FLOAT_INPUT, "squeeze", "Grab", handPaths_);
    actions_.menu = makeAction(menu_, XR_ACTION_TYPE_BOOLEAN_INPUT, "panel", "Show the panel", handPaths_);
    actions_.recentre =
        makeAction(menu_, XR_ACTION_TYPE_BOOLEAN_INPUT, "recentre", "Bring the workshop here", handPaths_);
    actions_.scroll = makeAction(menu_, XR_ACTION_TYPE_VECTOR2F_INPUT, "scroll", "Scroll", handPaths_);
}

void Input::makeTrackerActions() {
    for (const char* role : trackerRoles())
        rolePaths_.push_back(instance_.path(role));
    try {
        actions_.tracker = makeAction(weld_, XR_ACTION_TYPE_POSE_INPUT, "tracker", "Tracker on a torch", rolePaths_);
        actions_.trackerTrigger =
            makeAction(weld_, XR_ACTION_TYPE_FLOAT_INPUT, "tracker_trigger", "Trigger of the tracker", rolePaths_);
        actions_.trackerHaptic =
            makeAction(weld_, XR_ACTION_TYPE_VIBRATION_OUTPUT, "tracker_feel", "Vibration of the tracker", rolePaths_);
    } catch (const XrFault& fault) {
        refused_.push_back(std::string(kTrackerProfile) + " (" + resultName(fault.result()) + ")");
        rolePaths_.clear();
    }
}

XrAction Input::actionOf(Action action) const {
    switch (action) {
    case Action::grip:
        return actions_.grip;
    case Action::trigger:
        return actions_.trigger;
    case Action::haptic:
        return actions_.haptic;
    case Action::aim:
        return actions_.aim;
    case Action::squeeze:
        return actions_.squeeze;
    case Action::menu:
        return actions_.menu;
    case Action::recentre:
        return actions_.recentre;
    case Action::scroll:
        return actions_.scroll;
    }
    return XR_NULL_HANDLE;
}

void Input::suggest() {
    for (const InteractionProfile& profile : interactionProfiles()) {
        if (profile.extension != nullptr && !instance_.has(profile.extension)) continue;
        std::vector<XrActionSuggestedBinding> bindings;
        for (const HandBinding& binding : handBindings(profile))
            bindings.push_back({actionOf(binding.action), instance_.path(binding.path.c_str())});
        XrInteractionProfileSuggestedBinding suggestion{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING};
        suggestion.interactionProfile = instance_.path(profile.path);
        suggestion.countSuggestedBindings = uint32_t(bindings.size());
        suggestion.suggestedBindings = bindings.data();
        // A runtime that does not know one controller still takes the others.
        if (const XrResult result = xrSuggestInteractionProfileBindings(instance_.handle(), &suggestion);
            XR_FAILED(result))
            refused_.push_back(std::string(profile.path) + " (" + resultName(result) + ")");
    }
}

void Input::suggestTrackers() {
    if (rolePaths_.empty()) return;
    const auto suggestWith = [&](bool pins) {
        std::vector<XrActionSuggestedBinding> bindings;
        for (const std::string role : trackerRoles()) {
            bindings.push_back({actions_.tracker, instance_.path((role + "/input/grip/pose").c_str())});
            if (!pins) continue;
            bindings.push_back({actions_.trackerTrigger, instance_.path((role + "/input/trigger/value").c_str())});
            bindings.push_back({actions_.trackerHaptic, instance_.path((role + "/output/haptic").c_str())});
        }
        XrInteractionProfileSuggestedBinding suggestion{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING};
        suggestion.interactionProfile = instance_.path(kTrackerProfile);
        suggestion.countSuggestedBindings = uint32_t(bindings.size());
        suggestion.suggestedBindings = bindings.data();
        return xrSuggestInteractionProfileBindings(instance_.handle(), &suggestion);
    };
    // A runtime that refuses the pins may still take the pose.
    if (XR_SUCCEEDED(suggestWith(true))) return;
    if (const XrResult result = suggestWith(false); XR_FAILED(result))
        refused_.push_back(std::string(kTrackerProfile) + " (" + resultName(result) + ")");
}

void Input::attach() {
    const std::array<XrActionSet, 2> sets{weld_, menu_};
    XrSessionActionSetsAttachInfo info{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO};
    info.countActionSets = uint32_t(sets.size());
    info.actionSets = sets.data();
    MELTPOOL_XR(xrAttachSessionActionSets(session_.handle(), &info));
}

void Input::makeSpaces() {
    const auto make = [&](XrAction action, XrPath subaction) {
        XrActionSpaceCreateInfo info{XR_TYPE_ACTION_SPACE_CREATE_INFO};
        info.action = action;
        info.subactionPath = subaction;
        info.poseInActionSpace.orientation.w = 1;
        XrSpace space = XR_NULL_HANDLE;
        MELTPOOL_XR(xrCreateActionSpace(session_.handle(), &info, &space));
        return space;
    };
    for (size_t i = 0; i < handPaths_.size(); ++i) {
        gripSpaces_[i] = make(actions_.grip, handPaths_[i]);
        aimSpaces_[i] = make(actions_.aim, handPaths_[i]);
    }
    for (size_t i = 0; i < rolePaths_.size(); ++i) {
        roleSpaces_.push_back(make(actions_.tracker, rolePaths_[i]));
        const std::string role = trackerRoles()[i];
        trackers_.push_back({role.substr(role.rfind('/') + 1), false, {}, 0});
    }
    trackerOutputs_.resize(rolePaths_.size());
}

void Input::forget() {
    for (HandInput& hand : hands_) {
        const Pose grip = hand.grip, hold = hand.hold, aim = hand.aim;
        hand = {};
        hand.grip = grip;
        hand.hold = hold;
        hand.aim = aim;
    }
    for (TrackerInput& tracker : trackers_) {
        tracker.tracked = false;
        tracker.trigger = 0;
    }
}

void Input::read(XrTime time) {
    const std::array<XrActiveActionSet, 2> active{XrActiveActionSet{weld_, XR_NULL_PATH},
                                                  XrActiveActionSet{menu_, XR_NULL_PATH}};
    XrActionsSyncInfo sync{XR_TYPE_ACTIONS_SYNC_INFO};
    sync.countActiveActionSets = uint32_t(active.size());
    sync.activeActionSets = active.data();
    if (MELTPOOL_XR(xrSyncActions(session_.handle(), &sync)) == XR_SESSION_NOT_FOCUSED) {
        forget();
        return;
    }
    for (size_t i = 0; i < hands_.size(); ++i)
        readHand(i, time);
    for (size_t i = 0; i < trackers_.size(); ++i) {
        bool tracked = false;
        session_.locate(roleSpaces_[i], time, trackers_[i].pose, tracked);
        trackers_[i].tracked = tracked;
        trackers_[i].trigger = readFloat(actions_.trackerTrigger, rolePaths_[i]);
    }
}

void Input::readHand(size_t index, XrTime time) {
    HandInput& hand = hands_[index];
    const XrPath path = handPaths_[index];
    XrActionStatePose state{XR_TYPE_ACTION_STATE_POSE};
    const XrActionStateGetInfo grip = ask(actions_.grip, path);
    MELTPOOL_XR(xrGetActionStatePose(session_.handle(), &grip, &state));
    hand.present = state.isActive == XR_TRUE;
    hand.tracked = false;
    if (hand.present) {
        session_.locate(gripSpaces_[index], time, hand.grip, hand.tracked);
        hand.hold = hand.grip;
        bool aimTracked = false;
        session_.locate(aimSpaces_[index], time, hand.aim, aimTracked);
    }
    hand.trigger = readFloat(actions_.trigger, path);
    hand.squeeze = readFloat(actions_.squeeze, path);
    hand.menu = wentDown(actions_.menu, path);
    hand.recentre = wentDown(actions_.recentre, path);
    XrActionStateVector2f scroll{XR_TYPE_ACTION_STATE_VECTOR2F};
    const XrActionStateGetInfo get = ask(actions_.scroll, path);
    MELTPOOL_XR(xrGetActionStateVector2f(session_.handle(), &get, &scroll));
    hand.scrollX = scroll.isActive == XR_TRUE ? scroll.currentState.x : 0.0f;
    hand.scrollY = scroll.isActive == XR_TRUE ? scroll.currentState.y : 0.0f;
}

float Input::readFloat(XrAction action, XrPath hand) const {
    XrActionStateFloat state{XR_TYPE_ACTION_STATE_FLOAT};
    const XrActionStateGetInfo get = ask(action, hand);
    MELTPOOL_XR(xrGetActionStateFloat(session_.handle(), &get, &state));
    return state.isActive == XR_TRUE ? state.currentState : 0.0f;
}

bool Input::wentDown(XrAction action, XrPath hand) const {
    XrActionStateBoolean state{XR_TYPE_ACTION_STATE_BOOLEAN};
    const XrActionStateGetInfo get = ask(action, hand);
    MELTPOOL_XR(xrGetActionStateBoolean(session_.handle(), &get, &state));
    return state.isActive == XR_TRUE && state.changedSinceLastSync == XR_TRUE && state.currentState == XR_TRUE;
}

std::string Input::profile(Hand which) const {
    XrInteractionProfileState state{XR_TYPE_INTERACTION_PROFILE_STATE};
    MELTPOOL_XR(xrGetCurrentInteractionProfile(session_.handle(), handPaths_[size_t(which)], &state));
    return instance_.text(state.interactionProfile);
}

} // namespace meltpool::xr
