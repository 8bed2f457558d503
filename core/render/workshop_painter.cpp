#include "core/render/workshop_painter.hpp"

#include "shaders/shared/render.h"

#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>

namespace meltpool {

namespace {

/// Vertices as in shaders/render/room.vert.
constexpr int kVertices = (1 + WORKSHOP_BOXES) * 36 + 12 + WORKSHOP_BOTTLES * WORKSHOP_BOTTLE_SIDES * 6;

constexpr float kFromWall = 0.05f; ///< m between an eye and the walls, at least

} // namespace

bool insideRoom(const WorkshopView& room, std::span<const View> views) {
    const glm::mat4 toRoom = glm::inverse(room.toWorld);
    return std::all_of(views.begin(), views.end(), [&](const View& view) {
        const glm::vec3 eye = toRoom * glm::vec4(view.eye, 1);
        return glm::all(glm::greaterThan(eye, WORKSHOP_LOW + kFromWall)) &&
               glm::all(glm::lessThan(eye, WORKSHOP_HIGH - kFromWall));
    });
}

WorkshopPainter::WorkshopPainter(gl::ShaderLibrary& shaders)
    : program_(shaders, "render/room.vert", "render/sky.frag"), empty_("room") {}

void WorkshopPainter::draw(const WorkshopView& room, const ViewBatch& views, const RenderTarget& target) const {
    const gl::Program& program = program_.use(target, views);
    program.set("roomToWorld", room.toWorld);
    empty_.bind();
    glEnable(GL_CULL_FACE);
    glEnable(GL_DEPTH_CLAMP);
    glDepthFunc(GL_LEQUAL); // at the far plane later things cover earlier ones: the walls come first
    glDrawArraysInstanced(GL_TRIANGLES, 0, kVertices, views.count);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_CULL_FACE);
}

} // namespace meltpool
