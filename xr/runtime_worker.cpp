#include "xr/runtime_worker.hpp"

#include "core/gl/context.hpp"
#include "xr/device_speed.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool::xr {

namespace {

struct EyeSize {
    int width = 0;
    int height = 0;
};

EyeSize eyeSize(const Instance& instance, float scale) {
    uint32_t count = 0;
    constexpr auto kind = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    MELTPOOL_XR(xrEnumerateViewConfigurationViews(instance.handle(), instance.system(), kind, 0, &count, nullptr));
    std::vector<XrViewConfigurationView> views(count, {XR_TYPE_VIEW_CONFIGURATION_VIEW});
    MELTPOOL_XR(
        xrEnumerateViewConfigurationViews(instance.handle(), instance.system(), kind, count, &count, views.data()));
    if (views.size() != 2)
        throw InputError("the OpenXR runtime has " + std::to_string(views.size()) + " views; expected two eyes");
    const auto scaled = [&](uint32_t recommended, uint32_t most) {
        const int wanted = static_cast<int>(std::lround(static_cast<float>(recommended) * scale));
        return std::clamp(wanted, 16, static_cast<int>(most));
    };
    return {scaled(views[0].recommendedImageRectWidth, views[0].maxImageRectWidth),
            scaled(views[0].recommendedImageRectHeight, views[0].maxImageRectHeight)};
}

/// Makes the driver, not this thread, wait until the other context has reached the fence.
void waitFor(GLsync& fence) {
    if (fence == nullptr) return;
    glWaitSync(fence, 0, GL_TIMEOUT_IGNORED);
    glDeleteSync(fence);
    fence = nullptr;
}

} // namespace

RuntimeWorker::RuntimeWorker(std::unique_ptr<Instance> theInstance, const HeadsetSettings& settings,
                             std::unique_ptr<SharedContext> context)
    : instance(std::move(theInstance)), settings_(settings), context_(std::move(context)) {}

RuntimeWorker::~RuntimeWorker() {
    quads_ = {};
    colour_ = {};
    depth_ = {};
    from_.reset();
    to_.reset();
    for (GLsync& fence : {std::ref(copied), std::ref(submission.drawn)})
        if (fence != nullptr) glDeleteSync(fence);
    input.reset();
    session.reset();
    instance.reset();
    if (current_) context_->release();
}

void RuntimeWorker::open() {
    context_->makeCurrent();
    current_ = true;
    software_ = gl::drawnOnProcessor();
    const GraphicsBinding binding = GraphicsBinding::ofCurrentContext();
    bindingKind = binding.kind();
    session = std::make_unique<Session>(*instance, binding);
    requestSpeed(*session);
    input = std::make_unique<Input>(*session);
    makeSwapchains();
    from_ = std::make_unique<gl::Framebuffer>("submission source");
    to_ = std::make_unique<gl::Framebuffer>("submission target");
}

void RuntimeWorker::makeSwapchains() {
    const PictureFormats formats =
        choosePictureFormats(offeredFormats(*session), instance->has("XR_KHR_composition_layer_depth"));
    colourFormat = formats.colour;
    depthFormat = formats.depth;
    const EyeSize size = eyeSize(*instance, std::clamp(settings_.resolutionScale, 0.3f, 2.0f));
    width = size.width;
    height = size.height;
    for (size_t i = 0; i < colour_.size(); ++i) {
        colour_[i] = std::make_unique<Swapchain>(*session, colourFormat, width, height, false);
        if (depthFormat != GL_NONE) depth_[i] = std::make_unique<Swapchain>(*session, depthFormat, width, height, true);
    }
    for (size_t i = 0; i < kQuads; ++i) {
        const PanelShape& shape = i == size_t(Quad::panel) ? settings_.panel : settings_.notice;
        quads_[i] = std::make_unique<Swapchain>(*session, colourFormat, shape.widthPixels, shape.heightPixels, false);
    }
}

bool RuntimeWorker::testsLayerDepth() const {
    return depthFormat != GL_NONE && instance->has("XR_FB_composition_layer_depth_test");
}

void RuntimeWorker::poll() {
    session->poll();
}

void RuntimeWorker::waitFrame() {
    timing = session->waitFrame();
    if (session->takeMaskChange()) masks.read(*session);
    const SessionNews fresh = session->takeNews(timing.displayTime);
    if (fresh.profileChanged) input->onProfileChanged();
    news.add(fresh);
    input->read(timing.displayTime);
}

void RuntimeWorker::beginFrame() {
    session->beginFrame();
    if (timing.shouldRender) locateEyes();
}

void RuntimeWorker::locateEyes() {
    headTracked = session->locateEyes(timing.displayTime, views);
}

void RuntimeWorker::dropFrame() {
    session->dropFrame();
}

void RuntimeWorker::requestExit() {
    session->requestExit();
}

void RuntimeWorker::copy(GLuint from, int left, const Swapchain& to, GLuint texture, GLenum attachment,
                         GLbitfield what) {
    glDisable(GL_FRAMEBUFFER_SRGB); // the encoded values are copied unchanged
    glNamedFramebufferTexture(from_->name(), attachment, from, 0);
    glNamedFramebufferTexture(to_->name(), attachment, texture, 0);
    glBlitNamedFramebuffer(from_->name(), to_->name(), left, 0, left + to.width(), to.height(), 0, 0, to.width(),
                           to.height(), what, GL_NEAREST);
    glNamedFramebufferTexture(from_->name(), attachment, 0, 0);
    glNamedFramebufferTexture(to_->name(), attachment, 0, 0);
}

void RuntimeWorker::submitEyes() {
    for (size_t eye = 0; eye < colour_.size(); ++eye) {
        const int left = static_cast<int>(eye) * width;
        copy(submission.colour, left, *colour_[eye], colour_[eye]->acquire(), GL_COLOR_ATTACHMENT0,
             GL_COLOR_BUFFER_BIT);
        colour_[eye]->release();
        if (depth_[eye] == nullptr) continue;
        copy(submission.depth, left, *depth_[eye], depth_[eye]->acquire(), GL_DEPTH_ATTACHMENT, GL_DEPTH_BUFFER_BIT);
        depth_[eye]->release();
    }
    fillProjection();
    layers_.list[layers_.count++] = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layers_.projection);
}

void RuntimeWorker::fillProjection() {
    for (size_t eye = 0; eye < views.size(); ++eye) {
        XrCompositionLayerProjectionView& view = layers_.views[eye];
        view = {XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW};
        view.pose = toXr(views[eye].pose);
        view.fov = toXr(views[eye].fov);
        view.subImage = colour_[eye]->subImage();
        if (depth_[eye] == nullptr) continue;
        layers_.depths[eye] = {XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR};
        layers_.depths[eye].subImage = depth_[eye]->subImage();
        layers_.depths[eye].minDepth = 0.0f;
        layers_.depths[eye].maxDepth = 1.0f;
        layers_.depths[eye].nearZ = settings_.nearZ;
        layers_.depths[eye].farZ = settings_.farZ;
        view.next = &layers_.depths[eye];
    }
    layers_.projection.type = XR_TYPE_COMPOSITION_LAYER_PROJECTION;
    if (testsLayerDepth()) {
        // The compositor's depths are infinitely far at first: the eyes write theirs, and the quads behind are tested.
        layers_.projectionTest = {XR_TYPE_COMPOSITION_LAYER_DEPTH_TEST_FB, nullptr, XR_TRUE, XR_COMPARE_OP_ALWAYS_FB};
        layers_.projection.next = &layers_.projectionTest;
    }
    layers_.projection.space = session->space();
    layers_.projection.viewCount = uint32_t(layers_.views.size());
    layers_.projection.views = layers_.views.data();
}

void RuntimeWorker::submitQuad(size_t which) {
    const QuadSubmission& shown = submission.quads[which];
    Swapchain& chain = *quads_[which];
    if (shown.fresh) {
        copy(shown.texture, 0, chain, chain.acquire(), GL_COLOR_ATTACHMENT0, GL_COLOR_BUFFER_BIT);
        chain.release();
        filled_[which] = true;
    }
    if (!filled_[which]) return; // a layer needs a picture
    const PanelShape& shape = which == size_t(Quad::panel) ? settings_.panel : settings_.notice;
    XrCompositionLayerQuad& quad = layers_.quads[which];
    quad.type = XR_TYPE_COMPOSITION_LAYER_QUAD;
    quad.next = nullptr;
    if (submission.eyes && testsLayerDepth()) {
        // Without a write, so that the panel's clear parts do not hide the notice behind them.
        layers_.quadTest = {XR_TYPE_COMPOSITION_LAYER_DEPTH_TEST_FB, nullptr, XR_FALSE, XR_COMPARE_OP_LESS_OR_EQUAL_FB};
        quad.next = &layers_.quadTest;
    }
    quad.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
    quad.space = session->space();
    quad.eyeVisibility = XR_EYE_VISIBILITY_BOTH;
    quad.subImage = chain.subImage();
    quad.pose = toXr(shown.pose);
    const float metres = shown.width > 0 ? shown.width : shape.width;
    quad.size = {metres, metres * static_cast<float>(shape.heightPixels) / static_cast<float>(shape.widthPixels)};
    layers_.list[layers_.count++] = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&quad);
}

void RuntimeWorker::play() {
    for (const Hand hand : {Hand::left, Hand::right})
        if (submission.plays[size_t(hand)]) input->play(hand, submission.pulses[size_t(hand)]);
    if (submission.trackerPlays) input->playTracker(submission.tracker, submission.trackerPulse);
}

void RuntimeWorker::awaitDrawing() {
    constexpr GLuint64 kTurn = 1'000'000'000; // ns
    while (glClientWaitSync(submission.drawn, GL_SYNC_FLUSH_COMMANDS_BIT, kTurn) == GL_TIMEOUT_EXPIRED) {
    }
}

void RuntimeWorker::endFrame() {
    layers_.count = 0;
    waitFor(submission.drawn);
    if (submission.eyes) submitEyes();
    for (size_t i = 0; i < kQuads; ++i)
        if (submission.quads[i].shown) submitQuad(i);
    if (layers_.count > 0) {
        copied = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        glFlush();
        if (software_) glFinish();
    }
    play();
    session->endFrame(timing.displayTime, layers_.list.data(), layers_.count);
    poll();
}

} // namespace meltpool::xr
