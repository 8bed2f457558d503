#include "tests/windows/runtime/order.hpp"

#include <cstdlib>

namespace meltpool::test {

CallOrder& CallOrder::only() {
    static CallOrder one;
    return one;
}

CallOrder::CallOrder() {
    if (const char* name = std::getenv("MELTPOOL_TEST_RUNTIME_LOG")) log_.open(name, std::ios::app);
}

void CallOrder::note(const std::string& call) {
    const std::lock_guard lock(mutex_);
    log_ << call << "\n" << std::flush;
}

void CallOrder::fault(const std::string& what) {
    note("FAULT: " + what);
}

void CallOrder::requirementsAsked() {
    asked_ = true;
}

void CallOrder::sessionMade(const XrSessionCreateInfo& info) {
    if (!asked_) fault("a session before the requirements of OpenGL were asked for");
    const auto* binding = static_cast<const XrGraphicsBindingOpenGLWin32KHR*>(info.next);
    if (binding == nullptr || binding->type != XR_TYPE_GRAPHICS_BINDING_OPENGL_WIN32_KHR)
        return fault("a session without XrGraphicsBindingOpenGLWin32KHR");
    context_ = binding->hGLRC;
    deviceContext_ = binding->hDC;
    if (context_ == nullptr || context_ != wglGetCurrentContext())
        fault("the binding's context is not the current one");
    if (deviceContext_ == nullptr || deviceContext_ != wglGetCurrentDC())
        fault("the binding's device context is not the current one");
    if (GetPixelFormat(deviceContext_) == 0) fault("the binding's device context has no pixel format");
    if (GetObjectType(deviceContext_) != OBJ_DC) fault("the binding's device context is none");
    asked_ = false; // the next session must query again
}

void CallOrder::sessionDestroyed() {
    images_.clear();
    frame_ = Frame::none;
}

void CallOrder::needsContext(const char* call) {
    if (wglGetCurrentContext() != context_) fault(std::string(call) + " without the binding's context");
}

void CallOrder::acquired(XrSwapchain swapchain) {
    needsContext("xrAcquireSwapchainImage");
    if (images_[swapchain] != Image::free) fault("an image was acquired before the last one was released");
    images_[swapchain] = Image::acquired;
}

void CallOrder::waited(XrSwapchain swapchain) {
    needsContext("xrWaitSwapchainImage");
    if (images_[swapchain] != Image::acquired) fault("waited for an image that was not acquired");
    images_[swapchain] = Image::waited;
}

void CallOrder::released(XrSwapchain swapchain) {
    needsContext("xrReleaseSwapchainImage");
    if (images_[swapchain] != Image::waited) fault("an image was released that was not waited for");
    images_[swapchain] = Image::free;
}

void CallOrder::frameWaited() {
    if (frame_ == Frame::waited) fault("waited for a second frame before the first was begun");
    frame_ = Frame::waited;
}

void CallOrder::frameBegun() {
    if (frame_ != Frame::waited) fault("a frame was begun that was not waited for");
    frame_ = Frame::begun;
}

void CallOrder::frameEnded(const XrFrameEndInfo& info) {
    needsContext("xrEndFrame");
    if (frame_ != Frame::begun) fault("a frame was ended that was not begun");
    frame_ = Frame::none;
    for (const auto& [swapchain, image] : images_)
        if (image != Image::free && info.layerCount > 0) fault("a frame was ended before its images were released");
}

} // namespace meltpool::test
