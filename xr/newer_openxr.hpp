// Declares parts of OpenXR that are younger than the oldest header we compile with (1.0.20). The numbers are those of
// the Khronos registry; a newer header brings its own and its macros switch these off.
#pragma once

#include <openxr/openxr.h>

#ifndef XR_FB_composition_layer_depth_test // extension 213
constexpr auto XR_TYPE_COMPOSITION_LAYER_DEPTH_TEST_FB = static_cast<XrStructureType>(1000212000);

enum XrCompareOpFB {
    XR_COMPARE_OP_LESS_OR_EQUAL_FB = 3,
    XR_COMPARE_OP_ALWAYS_FB = 7,
    XR_COMPARE_OP_MAX_ENUM_FB = 0x7FFFFFFF,
};

struct XrCompositionLayerDepthTestFB {
    XrStructureType type;
    const void* next;
    XrBool32 depthMask;
    XrCompareOpFB compareOp;
};
#endif

#ifndef XR_EXT_local_floor // extension 427
constexpr auto XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR_EXT = static_cast<XrReferenceSpaceType>(1000426000);
#endif

#ifndef XR_EXT_user_presence // extension 471
constexpr auto XR_TYPE_EVENT_DATA_USER_PRESENCE_CHANGED_EXT = static_cast<XrStructureType>(1000470000);
constexpr auto XR_TYPE_SYSTEM_USER_PRESENCE_PROPERTIES_EXT = static_cast<XrStructureType>(1000470001);

struct XrEventDataUserPresenceChangedEXT {
    XrStructureType type;
    const void* next;
    XrSession session;
    XrBool32 isUserPresent;
};

struct XrSystemUserPresencePropertiesEXT {
    XrStructureType type;
    void* next;
    XrBool32 supportsUserPresence;
};
#endif
