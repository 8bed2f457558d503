// Provides the runtime's pictures for the headset, and chooses their formats.
#pragma once

#include "core/gl/gl.hpp"
#include "xr/session.hpp"

#include <optional>
#include <span>
#include <vector>

namespace meltpool::xr {

/// The best of the offered colour formats: 8-bit sRGB first, since every eye buffer holds finished sRGB pictures. Empty
/// if none can be written to.
std::optional<GLenum> chooseColourFormat(std::span<const std::int64_t> offered);

/// The best of the offered depth formats; empty: no depth layer is submitted.
std::optional<GLenum> chooseDepthFormat(std::span<const std::int64_t> offered);

/// Formats of the eyes.
struct PictureFormats {
    GLenum colour = GL_NONE;
    GLenum depth = GL_NONE; ///< GL_NONE: without a depth layer
};

/// Throws InputError, naming the offered formats, if no colour format will do.
PictureFormats choosePictureFormats(std::span<const std::int64_t> offered, bool depthLayer);

/// The formats that the runtime offers, in its own order of preference.
std::vector<std::int64_t> offeredFormats(const Session& session);

/// A chain of 2D pictures of one sample and one layer. Every runtime supports one chain an eye; not all support arrays.
class Swapchain {
  public:
    Swapchain(const Session& session, GLenum format, int width, int height, bool depth);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    GLenum format() const { return format_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Takes the next picture and waits until it may be written. Returns the texture's name.
    GLuint acquire();
    void release();
    XrSwapchainSubImage subImage() const;

  private:
    XrSwapchain handle_ = XR_NULL_HANDLE;
    GLenum format_ = 0;
    int width_ = 0;
    int height_ = 0;
    std::vector<GLuint> textures_;
};

} // namespace meltpool::xr
