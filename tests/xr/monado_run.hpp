// Provides a window's GL context, the test run's folder, and pictures of the compositor for tests on a real runtime.
#pragma once

#include "core/base/image.hpp"
#include "tests/xr/remote_driver.hpp"
#include "xr/headset.hpp"

#include <filesystem>
#include <functional>
#include <memory>

struct GLFWwindow;

namespace meltpool::test {

/// Returns the run's folder from tests/xr/run_on_monado.sh, and its port; throws RuntimeFault if the program was
/// started without it.
std::filesystem::path runFolder();
int driverPort();
/// Returns the runtime's process.
int servicePid();

/// Returns a hidden window with a current OpenGL 4.5 core context; one for the whole test program.
GLFWwindow* hiddenWindow();

/// Takes a picture of the X display, with both eyes as the compositor shows them.
Image screenshot();

/// Cuts out the compositor's picture of an eye (0 left, 1 right) on that screen.
Image shownEye(const Image& screen, int eye);

/// Writes the picture into the folder $MELTPOOL_XR_PICTURES if that is set.
void keepPicture(const Image& image, const std::string& name);

/// Returns the validation layer's errors and warnings since the last call, one a line; the layer checks every instance
/// of a test program that links this. Throws RuntimeFault if the layer did not run.
std::string misuses();

/// Time limit, s, far beyond any run on a busy machine: only a hang reaches it.
constexpr double kPatience = 300;

/// Calls `done()` 20 times a second until it is true; false only after kPatience.
bool waitUntil(const std::function<bool()>& done);

/// Steps a frame of a headset: poll, wait, input, draw. `draw` may be empty: an empty frame. Returns the frame's
/// timing, whose displayTime is 0 without a frame: the session does not run, or the runtime was too slow for a frame.
xr::FrameTiming stepFrame(xr::Headset& headset, const std::function<void(const xr::BothEyes&)>& draw,
                          const std::function<void()>& beforeEnd = {});

/// Steps that many whole frames; false only after kPatience.
bool stepFrames(xr::Headset& headset, int count, const std::function<void(const xr::BothEyes&)>& draw = {},
                const std::function<void()>& beforeEnd = {});

/// Steps frames until `done()`; false only after kPatience.
bool stepUntil(xr::Headset& headset, const std::function<bool()>& done,
               const std::function<void(const xr::BothEyes&)>& draw = {});

/// Waits until the session is open; false only after kPatience.
bool waitUntilOpen(xr::Headset& headset);

/// Opens the session and steps frames without pictures until it has the mode; false only after kPatience.
bool reach(xr::Headset& headset, xr::SessionMode mode);

} // namespace meltpool::test
