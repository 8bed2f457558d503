// Lists the controllers and their bindings.
#include "xr/profiles.hpp"

#include <array>

namespace meltpool::xr {

namespace {

using enum Action;
using enum Sides;

// A float action bound to a click reads 0 or 1, so every controller has a trigger.
constexpr SuggestedBinding kSimple[]{
    {grip, both, "input/grip/pose"},       {aim, both, "input/aim/pose"},    {haptic, both, "output/haptic"},
    {trigger, both, "input/select/click"}, {menu, both, "input/menu/click"},
};

constexpr SuggestedBinding kTouch[]{
    {grip, both, "input/grip/pose"},        {aim, both, "input/aim/pose"},
    {haptic, both, "output/haptic"},        {trigger, both, "input/trigger/value"},
    {squeeze, both, "input/squeeze/value"}, {menu, left, "input/y/click"},
    {menu, right, "input/b/click"},         {recentre, both, "input/thumbstick/click"},
    {scroll, both, "input/thumbstick"},
};

constexpr SuggestedBinding kIndex[]{
    {grip, both, "input/grip/pose"},        {aim, both, "input/aim/pose"},
    {haptic, both, "output/haptic"},        {trigger, both, "input/trigger/value"},
    {squeeze, both, "input/squeeze/value"}, {menu, both, "input/b/click"},
    {scroll, both, "input/thumbstick"},     {recentre, both, "input/thumbstick/click"},
};

constexpr SuggestedBinding kViveWand[]{
    {grip, both, "input/grip/pose"},        {aim, both, "input/aim/pose"},
    {haptic, both, "output/haptic"},        {trigger, both, "input/trigger/value"},
    {squeeze, both, "input/squeeze/click"}, {menu, both, "input/menu/click"},
    {scroll, both, "input/trackpad"},       {recentre, both, "input/trackpad/click"},
};

constexpr SuggestedBinding kWindowsMixedReality[]{
    {grip, both, "input/grip/pose"},        {aim, both, "input/aim/pose"},
    {haptic, both, "output/haptic"},        {trigger, both, "input/trigger/value"},
    {squeeze, both, "input/squeeze/click"}, {menu, both, "input/menu/click"},
    {scroll, both, "input/thumbstick"},     {recentre, both, "input/thumbstick/click"},
};

constexpr SuggestedBinding kHpReverb[]{
    {grip, both, "input/grip/pose"},        {aim, both, "input/aim/pose"},
    {haptic, both, "output/haptic"},        {trigger, both, "input/trigger/value"},
    {squeeze, both, "input/squeeze/value"}, {menu, both, "input/menu/click"},
    {scroll, both, "input/thumbstick"},     {recentre, both, "input/thumbstick/click"},
};

// Focus 3, XR Elite and Cosmos: the squeeze is bound as a click, which all their runtimes know.
constexpr SuggestedBinding kVive[]{
    {grip, both, "input/grip/pose"},        {aim, both, "input/aim/pose"},
    {haptic, both, "output/haptic"},        {trigger, both, "input/trigger/value"},
    {squeeze, both, "input/squeeze/click"}, {menu, left, "input/y/click"},
    {menu, right, "input/b/click"},         {recentre, both, "input/thumbstick/click"},
    {scroll, both, "input/thumbstick"},
};

// Its face buttons are all on the right hand, so each hand's own small button above them opens the panel.
constexpr SuggestedBinding kFrame[]{
    {grip, both, "input/grip/pose"},        {aim, both, "input/aim/pose"},
    {haptic, both, "output/haptic"},        {trigger, both, "input/trigger/value"},
    {squeeze, both, "input/squeeze/value"}, {menu, left, "input/view/click"},
    {menu, right, "input/menu/click"},      {recentre, both, "input/thumbstick/click"},
    {scroll, both, "input/thumbstick"},
};

// The paths are those of the extensions: OpenXR 1.1 renamed some, but we ask for 1.0 (see Instance).
constexpr auto kProfiles = std::to_array<InteractionProfile>({
    {"/interaction_profiles/khr/simple_controller", nullptr, kSimple},
    {"/interaction_profiles/oculus/touch_controller", nullptr, kTouch},
    {"/interaction_profiles/valve/index_controller", nullptr, kIndex},
    {"/interaction_profiles/htc/vive_controller", nullptr, kViveWand},
    {"/interaction_profiles/microsoft/motion_controller", nullptr, kWindowsMixedReality},
    {"/interaction_profiles/hp/mixed_reality_controller", "XR_EXT_hp_mixed_reality_controller", kHpReverb},
    {"/interaction_profiles/bytedance/pico_neo3_controller", "XR_BD_controller_interaction", kTouch},
    {"/interaction_profiles/bytedance/pico4_controller", "XR_BD_controller_interaction", kTouch},
    {"/interaction_profiles/bytedance/pico_ultra_controller_bd", "XR_BD_ultra_controller_interaction", kTouch},
    {"/interaction_profiles/htc/vive_focus3_controller", "XR_HTC_vive_focus3_controller_interaction", kVive},
    {"/interaction_profiles/htc/vive_cosmos_controller", "XR_HTC_vive_cosmos_controller_interaction", kVive},
    {"/interaction_profiles/facebook/touch_controller_pro", "XR_FB_touch_controller_pro", kTouch},
    {"/interaction_profiles/meta/touch_controller_plus", "XR_META_touch_controller_plus", kTouch},
    {"/interaction_profiles/valve/frame_controller_valve", "XR_VALVE_frame_controller_interaction", kFrame},
});

constexpr std::array<const char*, 5> kRoles{
    "/user/vive_tracker_htcx/role/handheld_object", "/user/vive_tracker_htcx/role/right_elbow",
    "/user/vive_tracker_htcx/role/left_elbow",      "/user/vive_tracker_htcx/role/camera",
    "/user/vive_tracker_htcx/role/keyboard",
};

} // namespace

std::span<const InteractionProfile> interactionProfiles() {
    return kProfiles;
}

std::span<const char* const> trackerRoles() {
    return kRoles;
}

std::vector<HandBinding> handBindings(const InteractionProfile& profile) {
    std::vector<HandBinding> all;
    for (const SuggestedBinding& binding : profile.bindings) {
        if (binding.sides != right)
            all.push_back({binding.action, 0, std::string("/user/hand/left/") + binding.component});
        if (binding.sides != left)
            all.push_back({binding.action, 1, std::string("/user/hand/right/") + binding.component});
    }
    return all;
}

} // namespace meltpool::xr
