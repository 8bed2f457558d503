// Declares parts of OpenXR that are younger than the oldest header we compile with (1.0.20). The numbers are those of
// the Khronos registry; a newer header brings its own and its macros switch these off.
#pragma once

#include <openxr/openxr.h>

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
