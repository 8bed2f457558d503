#include "core/render/solid_meshes.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr int kAround = 32;
constexpr float kFullTurn = 6.28318530717959f;

using Meshes = SolidMeshes;
using Vertex = SolidVertex;

void addQuad(Meshes& out, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    out.vertices.insert(out.vertices.end(), {a, b, c, d});
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        out.indices.push_back(first + corner);
}

void addBox(Meshes& out) {
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

/// Adds a grid of (columns + 1) x (rows + 1) corners, `at(column, row)`; seen from its front, columns go right and rows
/// up.
template <class At>
void addGrid(Meshes& out, int columns, int rows, const At& at) {
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    const auto line = static_cast<std::uint32_t>(columns + 1);
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            out.vertices.push_back(at(column, row));
    for (std::uint32_t cell = 0; cell < static_cast<std::uint32_t>(columns * rows); ++cell) {
        const std::uint32_t a = first + cell / (line - 1) * line + cell % (line - 1);
        out.indices.insert(out.indices.end(), {a, a + 1, a + line + 1, a, a + line + 1, a + line});
    }
}

glm::vec2 onCircle(int step, int around = kAround) {
    const float angle = kFullTurn * static_cast<float>(step) / static_cast<float>(around);
    return {std::cos(angle), std::sin(angle)};
}

/// A ring of a solid of revolution about z.
struct Ring {
    float radius;
    float z;
    glm::vec2 normal; ///< unit normal: outward and along z
};

void addRevolved(Meshes& out, const Ring& top, const Ring& bottom, int around = kAround) {
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    for (int step = 0; step <= around; ++step) {
        const glm::vec2 c = onCircle(step, around);
        for (const Ring* ring : {&top, &bottom})
            out.vertices.push_back({{c * ring->radius, ring->z}, {c * ring->normal.x, ring->normal.y}});
    }
    for (int step = 0; step < around; ++step) {
        const std::uint32_t a = first + 2 * static_cast<std::uint32_t>(step);
        out.indices.insert(out.indices.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
    }
}

/// Adds a ring-shaped or, with inner radius 0, round end.
void addEnd(Meshes& out, float z, float outer, float inner) {
    const glm::vec2 along(0, z > 0 ? 1 : -1);
    const Ring wide{outer, z, along}, narrow{inner, z, along};
    addRevolved(out, z > 0 ? narrow : wide, z > 0 ? wide : narrow);
}

/// Adds a cylinder or cone between two radii, with ends; a bore of this share of its width goes through.
void addTapered(Meshes& out, float topRadius, float bottomRadius, float bore = 0) {
    const glm::vec2 slope = glm::normalize(glm::vec2(1.0f, bottomRadius - topRadius));
    addRevolved(out, {topRadius, 0.5f, slope}, {bottomRadius, -0.5f, slope});
    if (bore > 0) addRevolved(out, {bottomRadius * bore, -0.5f, -slope}, {topRadius * bore, 0.5f, -slope});
    addEnd(out, 0.5f, topRadius, topRadius * bore);
    if (bottomRadius > 0) addEnd(out, -0.5f, bottomRadius, bottomRadius * bore);
}

/// Adds half an ellipsoid, or a whole one: rows from `firstRow` to `lastRow` of `rows` from pole to pole, about the
/// height `z`.
void addBall(Meshes& out, int firstRow, int lastRow, int rows, float z, float height, int around = kAround) {
    const auto ring = [&](int row) {
        const float angle = 0.5f * kFullTurn * static_cast<float>(row) / static_cast<float>(rows);
        const glm::vec2 normal = glm::normalize(glm::vec2(std::sin(angle), std::cos(angle) * 0.5f / height));
        return Ring{0.5f * std::sin(angle), z + height * std::cos(angle), normal};
    };
    for (int row = firstRow; row < lastRow; ++row)
        addRevolved(out, ring(row), ring(row + 1), around);
}

/// Adds a pill. Its ends are round at a length of twice its width. Hands and cables have many: it is coarser than the
/// rest.
void addPill(Meshes& out) {
    constexpr int kRows = 6, kSides = 20;
    constexpr float kEnd = 0.25f;
    addBall(out, 0, kRows / 2, kRows, kEnd, kEnd, kSides);
    addRevolved(out, {0.5f, kEnd, {1, 0}}, {0.5f, -kEnd, {1, 0}}, kSides);
    addBall(out, kRows / 2, kRows, kRows, -kEnd, kEnd, kSides);
}

/// Adds the superellipsoid |x|^n + |y|^n + |z|^n = 0.5^n, from the grid of a cube.
void addRounded(Meshes& out) {
    constexpr int kCells = 6;
    constexpr float kPower = 6;
    const auto pushed = [](glm::vec3 on) {
        const glm::vec3 powers = glm::pow(glm::abs(on), glm::vec3(kPower));
        const glm::vec3 at = 0.5f * on / std::pow(powers.x + powers.y + powers.z, 1 / kPower);
        return Vertex{at, glm::normalize(glm::sign(at) * glm::pow(glm::abs(at), glm::vec3(kPower - 1)))};
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f})
            addGrid(out, kCells, kCells, [&](int column, int row) {
                // Equal angles: finer towards the edges, which are the round parts.
                const auto place = [](int line) {
                    return std::sin(0.25f * kFullTurn * (2 * static_cast<float>(line) / kCells - 1));
                };
                glm::vec3 on(0.0f);
                on[axis] = side;
                on[(axis + 1) % 3] = side * place(column);
                on[(axis + 2) % 3] = place(row);
                return pushed(on);
            });
}

void addBend(Meshes& out) {
    constexpr int kPieces = 8;
    const auto at = [](int piece, int step) {
        const float turned = kBendAngle * static_cast<float>(piece) / kPieces;
        const glm::vec3 inward(std::cos(turned), 0, -std::sin(turned)); // direction to the middle that it turns about
        const glm::vec2 c = onCircle(step);
        const glm::vec3 normal = inward * c.x + glm::vec3(0, c.y, 0);
        return Vertex{glm::vec3(kBendRadius, 0, 0) - kBendRadius * inward + 0.5f * normal, normal};
    };
    addGrid(out, kAround, kPieces, [&](int step, int piece) { return at(piece, step); });
}

/// Light computed for its corners is fine enough for shadows of small things.
void addSlab(Meshes& out) {
    constexpr int kCells = 56;
    // Places from -0.5 to 0.5; the middle's cells are a seventh as wide as even ones would be.
    const auto line = [](int i) {
        const float even = static_cast<float>(i) / kCells - 0.5f;
        return even * (1 + 6 * 4 * even * even) / 7;
    };
    addGrid(out, kCells, kCells, [&](int column, int row) { return Vertex{{line(column), 0, -line(row)}, {0, 1, 0}}; });
}

/// Returns a fixed number 0..1 that looks random.
float scatter(int lane, int place) {
    const float wave =
        43758.5453f * std::sin(12.9898f * static_cast<float>(lane + 1) + 4.1414f * static_cast<float>(place));
    return wave - std::floor(wave);
}

/// A stick of chalk leaves streaks: each begins, ends and narrows where the stick did not touch.
void addChalk(Meshes& out) {
    constexpr int kLanes = 6, kPlaces = 26;
    constexpr float kLane = 1.0f / kLanes;
    for (int lane = 0; lane < kLanes; ++lane) {
        const float begin = -0.5f + 0.05f * scatter(lane, 91), end = 0.5f - 0.08f * scatter(lane, 92);
        const float middle = 0.9f * ((static_cast<float>(lane) + 0.5f) * kLane - 0.5f);
        addGrid(out, kPlaces, 1, [&](int place, int side) {
            const float share = static_cast<float>(place) / kPlaces;
            const float tip = std::min({1.0f, 0.4f + 8 * share, 0.4f + 8 * (1 - share)}); // narrower at both ends
            const float half = kLane * tip * (0.3f + 0.4f * scatter(lane, 2 * place + side));
            const float across = middle + (side == 0 ? half : -half);
            return Vertex{{begin + (end - begin) * share, 0, across}, {0, 1, 0}};
        });
    }
}

} // namespace

SolidMeshes makeSolidMeshes() {
    SolidMeshes all;
    const auto add = [&](SolidShape shape, const auto& fill) {
        const auto first = static_cast<int>(all.indices.size());
        fill(all);
        all.shapes[static_cast<size_t>(shape)] = {first, static_cast<int>(all.indices.size()) - first};
    };
    add(SolidShape::box, addBox);
    add(SolidShape::cylinder, [](Meshes& out) { addTapered(out, 0.5f, 0.5f); });
    add(SolidShape::cone, [](Meshes& out) { addTapered(out, 0.5f, 0); });
    add(SolidShape::sphere, [](Meshes& out) { addBall(out, 0, 16, 16, 0, 0.5f); });
    add(SolidShape::tube, [](Meshes& out) { addTapered(out, 0.5f, 0.5f, kTubeBore); });
    add(SolidShape::cup, [](Meshes& out) { addTapered(out, 0.5f, 0.5f * kCupMouth, kTubeBore); });
    add(SolidShape::taper, [](Meshes& out) { addTapered(out, 0.5f, 0.5f * kTaperEnd); });
    add(SolidShape::pill, addPill);
    add(SolidShape::rounded, addRounded);
    add(SolidShape::bend, addBend);
    add(SolidShape::slab, addSlab);
    add(SolidShape::chalk, addChalk);
    return all;
}

glm::mat4 alongLine(const glm::vec3& from, const glm::vec3& to, float width) {
    const glm::vec3 z = from - to;
    const float length = glm::length(z);
    const glm::vec3 unit = length > 0 ? z / length : glm::vec3(0, 0, 1);
    const glm::vec3 helper = std::abs(unit.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 x = glm::normalize(glm::cross(helper, unit));
    const glm::vec3 y = glm::cross(unit, x);
    return {glm::vec4(x * width, 0), glm::vec4(y * width, 0), glm::vec4(z, 0), glm::vec4(0.5f * (from + to), 1)};
}

glm::mat4 boxAt(const glm::vec3& middle, const glm::vec3& size) {
    return glm::scale(glm::translate(glm::mat4(1.0f), middle), size);
}

} // namespace meltpool
