// Makes swapchains and chooses their formats.
#include "xr/platform.hpp"

#include "xr/swapchain.hpp"

#include <algorithm>
#include <array>

namespace meltpool::xr {

namespace {

std::optional<GLenum> firstOffered(std::span<const GLenum> wanted, std::span<const std::int64_t> offered) {
    for (const GLenum format : wanted)
        if (std::find(offered.begin(), offered.end(), static_cast<std::int64_t>(format)) != offered.end())
            return format;
    return std::nullopt;
}

} // namespace

std::optional<GLenum> chooseColourFormat(std::span<const std::int64_t> offered) {
    constexpr std::array<GLenum, 3> wanted{GL_SRGB8_ALPHA8, GL_SRGB8, GL_RGBA8};
    return firstOffered(wanted, offered);
}

std::optional<GLenum> chooseDepthFormat(std::span<const std::int64_t> offered) {
    constexpr std::array<GLenum, 3> wanted{GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT16};
    return firstOffered(wanted, offered);
}

PictureFormats choosePictureFormats(std::span<const std::int64_t> offered, bool depthLayer) {
    const std::optional<GLenum> colour = chooseColourFormat(offered);
    if (!colour) {
        std::string list;
        for (const std::int64_t format : offered)
            list += (list.empty() ? "" : ", ") + std::to_string(format);
        throw InputError("the OpenXR runtime offers no 8-bit colour format for OpenGL; expected SRGB8_ALPHA8 or RGBA8, "
                         "found " +
                         (list.empty() ? "none" : list));
    }
    return {*colour, depthLayer ? chooseDepthFormat(offered).value_or(GL_NONE) : GLenum(GL_NONE)};
}

std::vector<std::int64_t> offeredFormats(const Session& session) {
    uint32_t count = 0;
    MELTPOOL_XR(xrEnumerateSwapchainFormats(session.handle(), 0, &count, nullptr));
    std::vector<std::int64_t> formats(count);
    MELTPOOL_XR(xrEnumerateSwapchainFormats(session.handle(), count, &count, formats.data()));
    return formats;
}

Swapchain::Swapchain(const Session& session, GLenum format, int width, int height, bool depth)
    : format_(format), width_(width), height_(height) {
    const ContextGuard guard;
    XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO};
    info.usageFlags = XR_SWAPCHAIN_USAGE_SAMPLED_BIT | (depth ? XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                                              : XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT);
    info.format = format;
    info.sampleCount = 1;
    info.width = static_cast<uint32_t>(width);
    info.height = static_cast<uint32_t>(height);
    info.faceCount = 1;
    info.arraySize = 1;
    info.mipCount = 1;
    MELTPOOL_XR(xrCreateSwapchain(session.handle(), &info, &handle_));
    uint32_t count = 0;
    MELTPOOL_XR(xrEnumerateSwapchainImages(handle_, 0, &count, nullptr));
    std::vector<XrSwapchainImageOpenGLKHR> images(count, {XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR});
    MELTPOOL_XR(xrEnumerateSwapchainImages(handle_, count, &count,
                                           reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())));
    for (const XrSwapchainImageOpenGLKHR& image : images)
        textures_.push_back(image.image);
}

Swapchain::~Swapchain() {
    const ContextGuard guard;
    xrDestroySwapchain(handle_);
}

GLuint Swapchain::acquire() {
    const ContextGuard guard;
    uint32_t index = 0;
    MELTPOOL_XR(xrAcquireSwapchainImage(handle_, nullptr, &index));
    XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
    wait.timeout = XR_INFINITE_DURATION;
    MELTPOOL_XR(xrWaitSwapchainImage(handle_, &wait));
    return textures_[index];
}

void Swapchain::release() {
    const ContextGuard guard;
    MELTPOOL_XR(xrReleaseSwapchainImage(handle_, nullptr));
}

XrSwapchainSubImage Swapchain::subImage() const {
    XrSwapchainSubImage part{};
    part.swapchain = handle_;
    part.imageRect.extent = {width_, height_};
    return part;
}

} // namespace meltpool::xr
