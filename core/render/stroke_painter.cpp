#include "core/render/stroke_painter.hpp"

namespace meltpool {

StrokePainter::StrokePainter(gl::ShaderLibrary& shaders)
    : program_(shaders, "render/strokes.vert", "render/strokes.frag"), empty_("strokes") {}

void StrokePainter::upload(std::span<const SectionStroke> strokes) {
    count_ = strokes.size();
    if (count_ == 0) return;
    if (strokes_.bytes() < strokes.size_bytes()) strokes_ = gl::Buffer("section strokes", strokes.size_bytes());
    strokes_.write(strokes);
}

void StrokePainter::draw(float at, const ViewBatch& views, const RenderTarget& target) const {
    if (count_ == 0) return;
    const gl::Program& program = program_.use(target, views);
    program.set("at", at);
    strokes_.bindStorage(STROKES_BINDING);
    empty_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * count_), views.count);
}

} // namespace meltpool
