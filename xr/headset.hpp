// A headset with a person in it: what a frame loop has to do, in the order in which it has to do it.
#pragma once

#include "core/base/function_ref.hpp"
#include "xr/eye_targets.hpp"
#include "xr/input.hpp"
#include "xr/panel.hpp"
#include "xr/swapchain.hpp"

#include <memory>

namespace meltpool::xr {

struct HeadsetSettings {
    float resolutionScale = 1.0f; ///< times the runtime's recommended size a side, 0.3..2
    int samples = 4;              ///< for each pixel of the eyes
    float nearZ = 0.02f;          ///< m
    float farZ = 50.0f;           ///< m
    PanelShape panel{};
};

/// Both eyes of one frame and what they are drawn into: side by side, left eye left, for one submission or two.
struct BothEyes {
    std::array<EyeView, 2> views; ///< in the session's space
    GLuint framebuffer = 0;       ///< colour and depth, perhaps multisampled, 2 * width wide
    int width = 0;                ///< pixels, of one eye
    int height = 0;
    bool encodesSrgb = true; ///< the colour format is sRGB
    float nearZ = 0;         ///< m, what the depth layer says of the projection
    float farZ = 0;
};

/// One session on one instance. A frame is
///
///     poll(); if (!running()) wait otherwise;
///     timing = waitFrame(); input().read(timing.displayTime); simulate; beginFrame();
///     if (timing.shouldRender) drawEyes(...);   // takes the head's pose as late as can be
///     endFrame();
class Headset {
  public:
    /// The OpenGL context that is current now draws. Throws XrFault or InputError (no usable format).
    Headset(std::unique_ptr<Instance> instance, const HeadsetSettings& settings);
    ~Headset();

    const Instance& instance() const { return *instance_; }
    Session& session() { return *session_; }
    const Session& session() const { return *session_; }
    Input& input() { return *input_; }
    const Input& input() const { return *input_; }
    Panel& panel() { return *panel_; }
    const Panel& panel() const { return *panel_; }
    const EyeTargets& eyes() const { return *targets_; }
    const HeadsetSettings& settings() const { return settings_; }
    bool hasDepthLayer() const { return depth_[0] != nullptr; }
    /// The binding's name: GLX, EGL, WGL.
    const char* bindingKind() const { return bindingKind_; }

    void poll();
    bool running() const { return session_->running(); }
    FrameTiming waitFrame();
    void beginFrame();
    /// Locates the head, lets `draw` fill both eyes and resolves them. False, and nothing drawn, where the head is not
    /// tracked.
    bool drawEyes(FunctionRef<void(const BothEyes&)> draw);
    /// Shows the panel at this pose in this frame.
    void showPanel(const Pose& pose);
    void endFrame();

    /// The views of the last drawEyes().
    const std::array<EyeView, 2>& views() const { return views_; }

  private:
    void makePictures();
    void handOver(size_t eye);
    void fillProjection();

    HeadsetSettings settings_;
    std::unique_ptr<Instance> instance_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<Input> input_;
    std::unique_ptr<EyeTargets> targets_;
    std::array<std::unique_ptr<Swapchain>, 2> colour_;
    std::array<std::unique_ptr<Swapchain>, 2> depth_;
    std::unique_ptr<Panel> panel_;
    const char* bindingKind_ = "";

    FrameTiming timing_;
    std::array<EyeView, 2> views_;
    std::array<XrCompositionLayerProjectionView, 2> projectionViews_{};
    std::array<XrCompositionLayerDepthInfoKHR, 2> depthInfos_{};
    XrCompositionLayerProjection projection_{};
    std::array<const XrCompositionLayerBaseHeader*, 2> layers_{};
    uint32_t layerCount_ = 0;
};

} // namespace meltpool::xr
