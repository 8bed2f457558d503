#include "core/render/solids.hpp"

#include "core/render/look/measures.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <vector>

namespace meltpool {

namespace {

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
};

constexpr int kAround = 32;
constexpr float kFullTurn = 6.28318530717959f;

void addTriangle(std::vector<Vertex>& out, const Vertex& a, const Vertex& b, const Vertex& c) {
    out.insert(out.end(), {a, b, c});
}

void addQuad(std::vector<Vertex>& out, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
    addTriangle(out, a, b, c);
    addTriangle(out, a, c, d);
}

void addBox(std::vector<Vertex>& out) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-0.5f, 0.5f}) {
            glm::vec3 normal(0.0f), u(0.0f), v(0.0f);
            normal[axis] = side * 2;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 0.5f;
            const glm::vec3 middle = normal * 0.5f;
            addQuad(out, {middle - u - v, normal}, {middle + u - v, normal}, {middle + u + v, normal},
                    {middle - u + v, normal});
        }
}

glm::vec2 onCircle(int step) {
    const float angle = kFullTurn * static_cast<float>(step) / kAround;
    return {std::cos(angle), std::sin(angle)};
}

/// A ring of a solid of revolution about z.
struct Ring {
    float radius;
    float z;
    glm::vec2 normal; ///< outward and along z, unit
};

void addRevolved(std::vector<Vertex>& out, const Ring& top, const Ring& bottom) {
    const auto at = [](const Ring& ring, int step) {
        const glm::vec2 c = onCircle(step);
        return Vertex{{c * ring.radius, ring.z}, {c * ring.normal.x, ring.normal.y}};
    };
    for (int step = 0; step < kAround; ++step)
        addQuad(out, at(top, step), at(bottom, step), at(bottom, step + 1), at(top, step + 1));
}

void addCylinder(std::vector<Vertex>& out) {
    addRevolved(out, {0, 0.5f, {0, 1}}, {0.5f, 0.5f, {0, 1}});
    addRevolved(out, {0.5f, 0.5f, {1, 0}}, {0.5f, -0.5f, {1, 0}});
    addRevolved(out, {0.5f, -0.5f, {0, -1}}, {0, -0.5f, {0, -1}});
}

void addCone(std::vector<Vertex>& out) {
    const glm::vec2 slope = glm::normalize(glm::vec2(1.0f, -0.5f));
    addRevolved(out, {0, 0.5f, {0, 1}}, {0.5f, 0.5f, {0, 1}});
    addRevolved(out, {0.5f, 0.5f, slope}, {0, -0.5f, slope});
}

void addSphere(std::vector<Vertex>& out) {
    constexpr int kRows = 16;
    const auto ring = [](int row) {
        const float angle = 0.5f * kFullTurn * static_cast<float>(row) / kRows;
        return Ring{0.5f * std::sin(angle), 0.5f * std::cos(angle), {std::sin(angle), std::cos(angle)}};
    };
    for (int row = 0; row < kRows; ++row)
        addRevolved(out, ring(row), ring(row + 1));
}

} // namespace

glm::mat4 alongLine(const glm::vec3& from, const glm::vec3& to, float width) {
    const glm::vec3 z = from - to;
    const float length = glm::length(z);
    const glm::vec3 unit = length > 0 ? z / length : glm::vec3(0, 0, 1);
    const glm::vec3 helper = std::abs(unit.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 x = glm::normalize(glm::cross(helper, unit));
    const glm::vec3 y = glm::cross(unit, x);
    return {glm::vec4(x * width, 0), glm::vec4(y * width, 0), glm::vec4(z, 0), glm::vec4(0.5f * (from + to), 1)};
}

SolidPainter::SolidPainter(gl::ShaderLibrary& shaders)
    : program_(shaders, "render/solid.vert", "render/solid.frag", {{bitOf(Measure::torchShadow), "TORCH_SHADOW"}}),
      markers_(shaders, "render/solid.vert", "render/marker.frag"),
      layout_("solid vertices") {
    std::vector<Vertex> all;
    int shape = 0;
    for (const auto add : {addBox, addCylinder, addCone, addSphere}) {
        const auto first = static_cast<int>(all.size());
        add(all);
        shapes_[static_cast<size_t>(shape++)] = {first, static_cast<int>(all.size()) - first};
    }
    vertices_ = gl::Buffer("solid vertices", std::span<const Vertex>(all));
    glVertexArrayVertexBuffer(layout_.name(), 0, vertices_.name(), 0, sizeof(Vertex));
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexArrayAttrib(layout_.name(), attribute);
        glVertexArrayAttribFormat(layout_.name(), attribute, 3, GL_FLOAT, GL_FALSE,
                                  static_cast<GLuint>(attribute * sizeof(glm::vec3)));
        glVertexArrayAttribBinding(layout_.name(), attribute, 0);
    }
}

void SolidPainter::draw(std::span<const Solid> solids, const ViewBatch& views, const RenderTarget& target) const {
    const gl::Program& program = program_.use(target, views);
    layout_.bind();
    for (const Solid& solid : solids) {
        const Range range = shapes_[static_cast<size_t>(solid.shape)];
        program.set("solidToWorld", solid.toWorld);
        program.set("paint", solid.colour);
        program.set("gloss", solid.gloss);
        program.set("glow", solid.glow);
        glDrawArraysInstanced(GL_TRIANGLES, range.first, range.count, views.count);
    }
}

void SolidPainter::draw(std::span<const Marker> markers, const ViewBatch& views, const RenderTarget& target) const {
    const gl::Program& program = markers_.use(target, views);
    layout_.bind();
    for (const Marker& marker : markers) {
        const Range range = shapes_[static_cast<size_t>(marker.shape)];
        program.set("solidToWorld", marker.toWorld);
        program.set("paint", marker.colour);
        program.set("cover", marker.opacity);
        program.set("face", marker.face);
        glDrawArraysInstanced(GL_TRIANGLES, range.first, range.count, views.count);
    }
}

} // namespace meltpool
