// Makes all calls of the OpenXR runtime on one thread with its own OpenGL context.
#pragma once

#include "core/gl/texture.hpp"
#include "xr/call_thread.hpp"
#include "xr/hidden_triangles.hpp"
#include "xr/input.hpp"
#include "xr/newer_openxr.hpp"
#include "xr/panel.hpp"
#include "xr/swapchain.hpp"

#include <array>
#include <memory>

namespace meltpool::xr {

struct HeadsetSettings {
    float resolutionScale = 1.0f; ///< factor of the runtime's recommended size a side, 0.3..2
    int samples = 4;              ///< samples of each pixel of the eyes
    float nearZ = 0.02f;          ///< m
    float farZ = 50.0f;           ///< m
    PanelShape panel{};
    PanelShape notice{900, 400, 0.36f};
};

/// Flat pictures in space, from the back to the front.
enum class Quad { panel, notice };
constexpr size_t kQuads = 2;

/// A flat picture in this frame.
struct QuadSubmission {
    bool shown = false;
    bool fresh = false; ///< the texture has a new picture; else the last one is shown again
    GLuint texture = 0;
    Pose pose;       ///< pose in the session's space
    float width = 0; ///< m; 0: the shape's
};

/// Contents that the drawing thread submits at the end of a frame. Set between calls.
struct FrameSubmission {
    bool eyes = false; ///< the textures below hold both eyes, the left eye on the left
    GLuint colour = 0; ///< 2 eyes wide
    GLuint depth = 0;  ///< 2 eyes wide
    std::array<QuadSubmission, kQuads> quads;
    GLsync drawn = nullptr;              ///< reached when both textures are drawn
    std::array<HapticPulse, 2> pulses{}; ///< pulses for the hands
    std::array<bool, 2> plays{};
    HapticPulse trackerPulse;
    size_t tracker = 0;
    bool trackerPlays = false;
};

/// Layers of a frame as the runtime reads them.
struct FrameLayers {
    std::array<XrCompositionLayerProjectionView, 2> views{};
    std::array<XrCompositionLayerDepthInfoKHR, 2> depths{};
    XrCompositionLayerProjection projection{};
    XrCompositionLayerDepthTestFB projectionTest{};
    std::array<XrCompositionLayerQuad, kQuads> quads{};
    XrCompositionLayerDepthTestFB quadTest{};
    std::array<const XrCompositionLayerBaseHeader*, 1 + kQuads> list{}; ///< from the back to the front
    uint32_t count = 0;
};

/// The drawing thread may use the public members between calls only.
class RuntimeWorker : public ThreadOwned {
  public:
    /// open() makes `context` current on the worker's thread.
    RuntimeWorker(std::unique_ptr<Instance> instance, const HeadsetSettings& settings,
                  std::unique_ptr<SharedContext> context);
    ~RuntimeWorker() override;

    // The calls.
    void open();       ///< makes session, actions and swapchains
    void poll();       ///< handles the runtime's events
    void waitFrame();  ///< waits for a frame and reads the controllers for it
    void beginFrame(); ///< begins the frame and locates the eyes for it
    void locateEyes();
    void awaitDrawing(); ///< waits until the submission's pictures are drawn
    void endFrame();     ///< submits `submission` and polls the runtime's events
    void dropFrame();    ///< ends an abandoned frame
    void requestExit();

    /// True for a driver without a card, which may not wait by itself for another context: awaitDrawing() is then
    /// needed before endFrame().
    bool drawsOnProcessor() const { return software_; }

    /// True if the runtime hides flat pictures behind nearer things of the eyes.
    bool testsLayerDepth() const;

    // Results.
    std::unique_ptr<Instance> instance;
    std::unique_ptr<Session> session;
    std::unique_ptr<Input> input;
    GLenum colourFormat = GL_NONE;
    GLenum depthFormat = GL_NONE; ///< GL_NONE: no depth layer
    int width = 0;                ///< pixels of one eye
    int height = 0;
    const char* bindingKind = "";
    FrameTiming timing;
    SessionNews news; ///< news for the frame waited for, cleared by the reader
    std::array<EyeView, 2> views;
    HiddenMasks masks;
    bool headTracked = false;
    GLsync copied = nullptr; ///< reached when the submission's textures may be drawn into again
    FrameSubmission submission;

  private:
    void makeSwapchains();
    void copy(GLuint from, int left, const Swapchain& to, GLuint texture, GLenum attachment, GLbitfield what);
    void submitEyes();
    void submitQuad(size_t which);
    void fillProjection();
    void play();

    HeadsetSettings settings_;
    std::unique_ptr<SharedContext> context_;
    bool current_ = false;
    bool software_ = false;
    std::array<std::unique_ptr<Swapchain>, 2> colour_;
    std::array<std::unique_ptr<Swapchain>, 2> depth_;
    std::array<std::unique_ptr<Swapchain>, kQuads> quads_;
    std::array<bool, kQuads> filled_{}; ///< a picture was released into the swapchain
    std::unique_ptr<gl::Framebuffer> from_, to_;
    FrameLayers layers_;
};

} // namespace meltpool::xr
