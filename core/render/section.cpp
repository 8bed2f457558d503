#include "core/render/section.hpp"

#include "shaders/shared/render.h"

#include <glm/vec4.hpp>

namespace meltpool {

namespace {

bool hasPicture(const SectionView& section) {
    return section.map != nullptr && !section.map->sums.empty();
}

} // namespace

SectionPainter::SectionPainter(gl::ShaderLibrary& shaders)
    : draw_(shaders, "render/section.vert", "render/section.frag"), empty_("section") {}

void SectionPainter::upload(const SectionView& section) {
    if (!hasPicture(section)) return;
    const glm::ivec2 texels = section.map->texels;
    if (!sums_ || sums_.shape().width != texels.x || sums_.shape().height != texels.y)
        sums_ = gl::Texture("section map", {.format = GL_RGBA32F, .width = texels.x, .height = texels.y});
    glTextureSubImage2D(sums_.name(), 0, 0, 0, texels.x, texels.y, GL_RGBA, GL_FLOAT, section.map->sums.data());
}

void SectionPainter::draw(const SectionView& section, const ViewBatch& views, const RenderTarget& target) const {
    if (!hasPicture(section)) return;
    const gl::Program& program = draw_.use(target, views);
    program.set("at", section.at);
    program.set("corner", section.map->low);
    program.set("size", section.map->size);
    program.set("spacing", section.map->spacing);
    sums_.bind(SECTION_UNIT);
    empty_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, views.count);
}

} // namespace meltpool
