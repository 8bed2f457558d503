// Includes OpenXR with its OpenGL types, and the window system's headers that those need, without their macros.
#pragma once

#include "core/gl/gl.hpp"

#ifdef _WIN32
#include <windows.h>

#include <unknwn.h>
#define XR_USE_PLATFORM_WIN32
#else
#include <EGL/egl.h>
#include <GL/glx.h>
#define XR_USE_PLATFORM_XLIB
#define XR_USE_PLATFORM_EGL
#endif
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#undef None
#undef Bool
#undef Success
