#include "app/headset/mirror.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace meltpool {

namespace {

// m; the flat pictures are between these distances from the eye.
constexpr float kNear = 0.02f, kFar = 20;

} // namespace

void Mirror::addFlat(const xr::Panel& picture, const xr::Pose& pose, float width) {
    if (count_ < flat_.size()) flat_[count_++] = {&picture, pose, width};
}

void Mirror::draw(const xr::Headset& headset, glm::ivec2 pixels, gl::ShaderLibrary& shaders) {
    if (program_ == nullptr) program_ = &shaders.load({"render/flat_picture.vert", "render/flat_picture.frag"});
    const xr::EyeTargets& eyes = headset.eyes();
    const double aspect = double(pixels.x) / double(pixels.y);
    const int width = std::min(eyes.width(), int(eyes.height() * aspect));
    const int height = std::min(eyes.height(), int(width / aspect));
    const int x = (eyes.width() - width) / 2, y = (eyes.height() - height) / 2;
    glBlitNamedFramebuffer(eyes.resolved(), 0, x, y, x + width, y + height, 0, 0, pixels.x, pixels.y,
                           GL_COLOR_BUFFER_BIT, GL_LINEAR);
    if (count_ == 0) return;
    // The viewport is the whole eye, of which the window cuts out the middle.
    const double scale = double(pixels.x) / double(std::max(width, 1));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(int(-x * scale), int(-y * scale), int(eyes.width() * scale), int(eyes.height() * scale));
    drawFlat(headset);
}

void Mirror::drawFlat(const xr::Headset& headset) const {
    for (const GLenum capability : {GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_CULL_FACE, GL_FRAMEBUFFER_SRGB})
        glDisable(capability);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); // as the runtime blends them
    const xr::EyeView& eye = headset.views()[0];
    const glm::mat4 toClip = xr::projection(eye.fov, kNear, kFar) * eye.pose.inverse().matrix();
    program_->use();
    program_->set("decoded", headset.eyes().encodesSrgb() ? 1 : 0);
    empty_.bind();
    for (size_t i = count_; i-- > 0;) {
        const xr::PanelShape& shape = flat_[i].picture->shape();
        const float height = flat_[i].width * float(shape.heightPixels) / float(shape.widthPixels);
        program_->set("toClip", toClip * glm::scale(flat_[i].pose.matrix(), {flat_[i].width, height, 1.0f}));
        glBindTextureUnit(0, flat_[i].picture->texture());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    glDisable(GL_BLEND);
}

} // namespace meltpool
