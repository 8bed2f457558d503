// Places the panel in space and the pointer's ray on it.
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

Panel::Panel(GLenum format, const PanelShape& shape)
    : shape_(shape),
      colour_("panel", {GL_TEXTURE_2D, format, shape.widthPixels, shape.heightPixels, 1, 1, 1}),
      framebuffer_("panel") {
    framebuffer_.attach(GL_COLOR_ATTACHMENT0, colour_);
    framebuffer_.requireComplete();
}

} // namespace meltpool::xr
