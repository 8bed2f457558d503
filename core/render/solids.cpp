#include "core/render/solids.hpp"

#include "core/render/look/measures.hpp"

#include "shaders/shared/render.h"

#include <cstddef>

namespace meltpool {

namespace {

const std::vector<std::pair<unsigned, std::string>> kOfSolids{{bitOf(DetailFeature::torchShadow), "TORCH_SHADOW"}};

} // namespace

SolidPainter::SolidPainter(gl::ShaderLibrary& shaders)
    : program_(shaders, "render/solid.vert", "render/solid.frag", kOfSolids, {{"MANY_AT_ONCE", "1"}}),
      standing_(shaders, "render/solid.vert", "render/solid.frag", kOfSolids,
                {{"MANY_AT_ONCE", "1"}, {"ON_TABLE", "1"}}),
      markers_(shaders, "render/solid.vert", "render/marker.frag"),
      layout_("solid vertices") {
    const SolidMeshes meshes = makeSolidMeshes();
    shapes_ = meshes.shapes;
    vertices_ = gl::Buffer("solid vertices", std::span<const SolidVertex>(meshes.vertices));
    indices_ = gl::Buffer("solid indices", std::span<const std::uint32_t>(meshes.indices));
    const GLuint layout = layout_.name();
    glVertexArrayElementBuffer(layout, indices_.name());
    glVertexArrayVertexBuffer(layout, 0, vertices_.name(), 0, sizeof(SolidVertex));
    const auto attribute = [&](GLuint index, GLuint binding, GLint size, size_t offset) {
        glEnableVertexArrayAttrib(layout, index);
        glVertexArrayAttribFormat(layout, index, size, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
        glVertexArrayAttribBinding(layout, index, binding);
    };
    attribute(0, 0, 3, offsetof(SolidVertex, position));
    attribute(1, 0, 3, offsetof(SolidVertex, normal));
    for (GLuint column = 0; column < 4; ++column)
        attribute(SOLID_PLACE_ATTRIBUTE + column, 1, 4, offsetof(Instance, toWorld) + column * sizeof(glm::vec4));
    attribute(SOLID_PAINT_ATTRIBUTE, 1, 4, offsetof(Instance, paint));
    attribute(SOLID_GLOW_ATTRIBUTE, 1, 3, offsetof(Instance, glow));
    for (gl::Buffer& buffer : instances_)
        buffer = gl::Buffer("solids", sizeof(Instance));
}

void SolidPainter::begin() {
    for (Kind& kind : kinds_) {
        kind.free.clear();
        kind.standing.clear();
    }
}

void SolidPainter::gather(std::span<const Solid> solids, bool standing, bool coarse) {
    for (const Solid& solid : solids) {
        if (solid.coarse && !coarse) continue;
        Kind& kind = kinds_[static_cast<size_t>(solid.shape)];
        (standing ? kind.standing : kind.free)
            .push_back({solid.toWorld, glm::vec4(solid.colour, solid.gloss), glm::vec4(solid.glow, 0)});
    }
}

void SolidPainter::upload() {
    all_.clear();
    for (const Kind& kind : kinds_) {
        all_.insert(all_.end(), kind.free.begin(), kind.free.end());
        all_.insert(all_.end(), kind.standing.begin(), kind.standing.end());
    }
    if (all_.empty()) return;
    current_ = (current_ + 1) % kFramesInFlight;
    gl::Buffer& buffer = instances_[current_];
    const std::span<const Instance> instances(all_);
    if (buffer.bytes() < instances.size_bytes()) buffer = gl::Buffer("solids", 2 * instances.size_bytes());
    buffer.write(instances);
    glVertexArrayVertexBuffer(layout_.name(), 1, buffer.name(), 0, sizeof(Instance));
}

void SolidPainter::drawKinds(const MeasuredProgram& program, bool standing, const ViewBatch& views,
                             const RenderTarget& target) const {
    bool used = false;
    GLuint first = 0;
    for (size_t shape = 0; shape < kSolidShapes; ++shape) {
        const Kind& kind = kinds_[shape];
        const size_t count = standing ? kind.standing.size() : kind.free.size();
        const GLuint begin = first + static_cast<GLuint>(standing ? kind.free.size() : 0);
        first += static_cast<GLuint>(kind.free.size() + kind.standing.size());
        if (count == 0) continue;
        if (!used) program.use(target, views).set("viewsTogether", views.count);
        used = true;
        const SolidMeshes::Range range = shapes_[shape];
        const void* indices = reinterpret_cast<const void*>(static_cast<size_t>(range.first) * sizeof(GLuint));
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, range.count, GL_UNSIGNED_INT, indices,
                                            static_cast<GLsizei>(count) * views.count, begin);
    }
}

void SolidPainter::draw(const ViewBatch& views, const RenderTarget& target) const {
    if (all_.empty()) return;
    layout_.bind();
    // The instances of a solid, one for each view, follow each other.
    glVertexArrayBindingDivisor(layout_.name(), 1, static_cast<GLuint>(views.count));
    drawKinds(program_, false, views, target);
    drawKinds(standing_, true, views, target);
}

void SolidPainter::draw(std::span<const Marker> markers, const ViewBatch& views, const RenderTarget& target) const {
    if (markers.empty()) return;
    const gl::Program& program = markers_.use(target, views);
    layout_.bind();
    for (const Marker& marker : markers) {
        const SolidMeshes::Range range = shapes_[static_cast<size_t>(marker.shape)];
        program.set("solidToWorld", marker.toWorld);
        program.set("paint", marker.colour);
        program.set("cover", marker.opacity);
        program.set("face", marker.face);
        const void* indices = reinterpret_cast<const void*>(static_cast<size_t>(range.first) * sizeof(GLuint));
        glDrawElementsInstanced(GL_TRIANGLES, range.count, GL_UNSIGNED_INT, indices, views.count);
    }
}

} // namespace meltpool
