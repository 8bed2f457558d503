// The panel in space and the pointer's ray on it.
#include "xr/panel.hpp"

namespace meltpool::xr {

std::optional<glm::vec2> pointOnPanel(const Pose& ray, const Pose& panel, const PanelShape& shape) {
    const Pose local = panel.inverse() * ray; // the panel is the plane z = 0
    const glm::vec3 direction = local.forward();
    if (local.position.z <= 0 || direction.z >= 0) return std::nullopt;
    const glm::vec3 hit = local.position + direction * (-local.position.z / direction.z);
    const float pixelsPerMetre = static_cast<float>(shape.widthPixels) / shape.width;
    const glm::vec2 size(float(shape.widthPixels), float(shape.heightPixels));
    const glm::vec2 pixel = size * 0.5f + glm::vec2(hit.x, -hit.y) * pixelsPerMetre;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) return std::nullopt;
    return pixel;
}

Panel::Panel(const Session& session, GLenum format, const PanelShape& shape)
    : shape_(shape),
      swapchain_(session, format, shape.widthPixels, shape.heightPixels, false),
      colour_("panel", {GL_TEXTURE_2D, format, shape.widthPixels, shape.heightPixels, 1, 1, 1}),
      framebuffer_("panel"),
      handover_("panel handover") {
    framebuffer_.attach(GL_COLOR_ATTACHMENT0, colour_);
    framebuffer_.requireComplete();
}

void Panel::handOver() {
    const GLuint texture = swapchain_.acquire();
    glDisable(GL_FRAMEBUFFER_SRGB);
    glNamedFramebufferTexture(handover_.name(), GL_COLOR_ATTACHMENT0, texture, 0);
    const int w = shape_.widthPixels, h = shape_.heightPixels;
    glBlitNamedFramebuffer(framebuffer(), handover_.name(), 0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glNamedFramebufferTexture(handover_.name(), GL_COLOR_ATTACHMENT0, 0, 0);
    swapchain_.release();
}

const XrCompositionLayerBaseHeader* Panel::layer(XrSpace space, const Pose& pose) {
    quad_.type = XR_TYPE_COMPOSITION_LAYER_QUAD;
    quad_.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
    quad_.space = space;
    quad_.eyeVisibility = XR_EYE_VISIBILITY_BOTH;
    quad_.subImage = swapchain_.subImage();
    quad_.pose = toXr(pose);
    quad_.size = {shape_.width,
                  shape_.width * static_cast<float>(shape_.heightPixels) / static_cast<float>(shape_.widthPixels)};
    return reinterpret_cast<const XrCompositionLayerBaseHeader*>(&quad_);
}

} // namespace meltpool::xr
