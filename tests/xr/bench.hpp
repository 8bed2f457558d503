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

/// The program's window of that title as it is shown now, moved to the screen's lower right corner and raised. Throws
/// RuntimeFault where there is none.
Image windowPicture(const std::string& title);

/// Where the compositor shows an eye (0 left, 1 right) on that screen, cut out.
Image shownEye(const Image& screen, int eye);

/// Writes the picture into the folder $MELTPOOL_XR_PICTURES where that is set.
void keepPicture(const Image& image, const std::string& name);

/// The validation layer's errors and warnings since the last call, one a line; the layer checks every instance of a
/// test program that links this. Throws RuntimeFault when the layer did not run.
std::string misuses();

/// Steps frames of a headset: poll, wait, input, draw. `draw` may be empty: an empty frame. Answers the frame's timing.
xr::FrameTiming stepFrame(xr::Headset& headset, const std::function<void(const xr::BothEyes&)>& draw,
                          const std::function<void()>& beforeEnd = {});

/// Polls until the session has the mode (frames without pictures meanwhile); false after `seconds`.
bool reach(xr::Headset& headset, xr::SessionMode mode, double seconds = 10);

} // namespace meltpool::test
