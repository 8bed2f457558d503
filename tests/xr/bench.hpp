// For tests on a real runtime: a window's GL context, the test run's folder, and pictures of the compositor.
#pragma once

#include "core/base/image.hpp"
#include "tests/xr/remote_driver.hpp"
#include "xr/headset.hpp"

#include <filesystem>
#include <functional>
#include <memory>

struct GLFWwindow;

namespace meltpool::test {

/// The run's folder and port, from tests/xr/bench.sh; throws RuntimeFault when the program was started without it.
std::filesystem::path benchFolder();
int benchPort();
/// The runtime's process.
int servicePid();

/// A hidden window with a current OpenGL 4.5 core context; one for the whole test program.
GLFWwindow* benchWindow();

/// The X display as it is shown now, with both eyes as the compositor shows them.
Image screenshot();

/// Moves the program's window of that title to the screen's lower right corner, before all others. Frames must be drawn
/// before it shows what was covered. Throws RuntimeFault where there is none.
void showWindow(const std::string& title);
/// That window as it is shown now.
Image windowPicture(const std::string& title);

/// Where the compositor shows an eye (0 left, 1 right) on that screen, cut out.
Image shownEye(const Image& screen, int eye);

/// Writes the picture into the folder $MELTPOOL_XR_PICTURES where that is set.
void keepPicture(const Image& image, const std::string& name);

/// The validation layer's errors and warnings since the last call, one a line; the layer checks every instance of a
/// test program that links this. Throws RuntimeFault when the layer did not run.
std::string misuses();

/// Far beyond what anything here takes on a busy machine, s: only a hang gets there.
constexpr double kPatience = 300;

/// Looks 20 times a second until `done()`; false only after kPatience.
bool waitUntil(const std::function<bool()>& done);

/// Steps a frame of a headset: poll, wait, input, draw. `draw` may be empty: an empty frame. Answers the frame's
/// timing, whose displayTime is 0 where there was none: the session does not run, or the runtime was too slow for a
/// frame.
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
