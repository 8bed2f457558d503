// The headset's pictures and frames.
#include "xr/headset.hpp"

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

} // namespace

Headset::Headset(std::unique_ptr<Instance> instance, const HeadsetSettings& settings)
    : settings_(settings), instance_(std::move(instance)) {
    const GraphicsBinding binding = GraphicsBinding::ofCurrentContext();
    bindingKind_ = binding.kind();
    session_ = std::make_unique<Session>(*instance_, binding);
    input_ = std::make_unique<Input>(*session_);
    makePictures();
}

Headset::~Headset() = default;

void Headset::makePictures() {
    const std::vector<std::int64_t> offered = offeredFormats(*session_);
    const std::optional<GLenum> colour = chooseColourFormat(offered);
    if (!colour)
        throw InputError("the OpenXR runtime offers no 8-bit colour format for OpenGL; expected SRGB8_ALPHA8 or RGBA8");
    const GLenum depth = chooseDepthFormat(offered).value_or(GL_NONE);
    const bool depthLayer = depth != GL_NONE && instance_->has("XR_KHR_composition_layer_depth");
    const EyeSize size = eyeSize(*instance_, std::clamp(settings_.resolutionScale, 0.3f, 2.0f));
    targets_ = std::make_unique<EyeTargets>(*colour, depthLayer ? depth : GL_DEPTH_COMPONENT32F, size.width,
                                            size.height, settings_.samples);
    for (size_t i = 0; i < colour_.size(); ++i) {
        colour_[i] = std::make_unique<Swapchain>(*session_, *colour, size.width, size.height, false);
        if (depthLayer) depth_[i] = std::make_unique<Swapchain>(*session_, depth, size.width, size.height, true);
    }
    panel_ = std::make_unique<Panel>(*session_, *colour, settings_.panel);
}

void Headset::poll() {
    session_->poll();
}

FrameTiming Headset::waitFrame() {
    timing_ = session_->waitFrame();
    return timing_;
}

void Headset::beginFrame() {
    session_->beginFrame();
    layerCount_ = 0;
}

bool Headset::drawEyes(FunctionRef<void(const BothEyes&)> draw) {
    if (!session_->locateEyes(timing_.displayTime, views_)) return false;
    draw({views_, targets_->framebuffer(), targets_->width(), targets_->height(), targets_->encodesSrgb(),
          settings_.nearZ, settings_.farZ});
    targets_->resolve();
    for (size_t eye = 0; eye < views_.size(); ++eye)
        handOver(eye);
    fillProjection();
    layers_[layerCount_++] = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&projection_);
    return true;
}

void Headset::handOver(size_t eye) {
    targets_->copyColour(int(eye), colour_[eye]->acquire());
    colour_[eye]->release();
    if (depth_[eye] == nullptr) return;
    targets_->copyDepth(int(eye), depth_[eye]->acquire());
    depth_[eye]->release();
}

void Headset::fillProjection() {
    for (size_t eye = 0; eye < views_.size(); ++eye) {
        XrCompositionLayerProjectionView& view = projectionViews_[eye];
        view = {XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW};
        view.pose = toXr(views_[eye].pose);
        view.fov = toXr(views_[eye].fov);
        view.subImage = colour_[eye]->subImage();
        if (depth_[eye] == nullptr) continue;
        depthInfos_[eye] = {XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR};
        depthInfos_[eye].subImage = depth_[eye]->subImage();
        depthInfos_[eye].minDepth = 0.0f;
        depthInfos_[eye].maxDepth = 1.0f;
        depthInfos_[eye].nearZ = settings_.nearZ;
        depthInfos_[eye].farZ = settings_.farZ;
        view.next = &depthInfos_[eye];
    }
    projection_.type = XR_TYPE_COMPOSITION_LAYER_PROJECTION;
    projection_.space = session_->space();
    projection_.viewCount = uint32_t(projectionViews_.size());
    projection_.views = projectionViews_.data();
}

void Headset::showPanel(const Pose& pose) {
    if (layerCount_ < layers_.size()) layers_[layerCount_++] = panel_->layer(session_->space(), pose);
}

void Headset::endFrame() {
    session_->endFrame(timing_.displayTime, layers_.data(), layerCount_);
}

} // namespace meltpool::xr
