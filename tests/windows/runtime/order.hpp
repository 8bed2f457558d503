// The call order that OpenXR demands, checked by the test runtime for Windows.
#pragma once

#include <fstream>
#include <map>
#include <mutex>
#include <string>

#include "xr/platform.hpp"

namespace meltpool::test {

/// Writes each call into the file that MELTPOOL_TEST_RUNTIME_LOG names, and "FAULT: ..." for a wrong order.
class CallOrder {
  public:
    static CallOrder& only();

    void note(const std::string& call);
    void fault(const std::string& what);

    void requirementsAsked();
    void sessionMade(const XrSessionCreateInfo& info);
    void sessionDestroyed();
    /// Checks a call that needs the program's context.
    void needsContext(const char* call);
    void acquired(XrSwapchain swapchain);
    void waited(XrSwapchain swapchain);
    void released(XrSwapchain swapchain);
    void frameWaited();
    void frameBegun();
    void frameEnded(const XrFrameEndInfo& info);

  private:
    enum class Image { free, acquired, waited };
    enum class Frame { none, waited, begun };

    CallOrder();

    std::mutex mutex_;
    std::ofstream log_;
    bool asked_ = false;
    HGLRC context_ = nullptr;
    HDC deviceContext_ = nullptr;
    std::map<XrSwapchain, Image> images_;
    Frame frame_ = Frame::none;
};

} // namespace meltpool::test
