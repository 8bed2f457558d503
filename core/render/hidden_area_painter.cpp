#include "core/render/hidden_area_painter.hpp"

#include "core/render/view_submission.hpp"

namespace meltpool {

namespace {

bool hides(std::span<const View> views, const RenderTarget& target) {
    return target.hidden != nullptr && views.size() == target.hidden->corners.size();
}

} // namespace

HiddenAreaPainter::HiddenAreaPainter(gl::ShaderLibrary& shaders)
    : program_(shaders.load({"render/hidden_area.vert", "render/hidden_area.frag"})) {
    glEnableVertexArrayAttrib(layout_.name(), 0);
    glVertexArrayAttribBinding(layout_.name(), 0, 0);
    glVertexArrayAttribFormat(layout_.name(), 0, 2, GL_FLOAT, GL_FALSE, 0);
}

void HiddenAreaPainter::upload(const HiddenArea& area) {
    if (version_ == area.version) return;
    version_ = area.version;
    corners_ = gl::Buffer("hidden area", area.corners[0].size_bytes() + area.corners[1].size_bytes());
    corners_.write(area.corners[0]);
    corners_.write(area.corners[1], area.corners[0].size_bytes());
    glVertexArrayVertexBuffer(layout_.name(), 0, corners_.name(), 0, sizeof(glm::vec2));
}

void HiddenAreaPainter::draw(std::span<const View> views, const RenderTarget& target) {
    if (!hides(views, target)) return;
    upload(*target.hidden);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawTriangles(views, target);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LESS);
}

void HiddenAreaPainter::blacken(std::span<const View> views, const RenderTarget& target) {
    if (!hides(views, target)) return;
    upload(*target.hidden);
    glDisable(GL_DEPTH_TEST);
    drawTriangles(views, target);
}

void HiddenAreaPainter::drawTriangles(std::span<const View> views, const RenderTarget& target) {
    program_.use();
    layout_.bind();
    GLint first = 0;
    for (size_t i = 0; i < views.size(); ++i) {
        const auto count = static_cast<GLsizei>(target.hidden->corners[i].size());
        aim({static_cast<int>(i), 1, ViewSubmission::passes}, target.viewport, static_cast<int>(views.size()));
        program_.set("eyeToClip", views[i].eyeToClip);
        glDrawArrays(GL_TRIANGLES, first, count);
        first += count;
    }
}

} // namespace meltpool
