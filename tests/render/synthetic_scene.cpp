#include "tests/render/synthetic_scene.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace meltpool::test {

namespace {

constexpr int kCells = 40; // cells per edge of the cube
const glm::vec3 kCorner(0.5f);

/// Returns the temperature left by a flame at the corner: 1 at it, 0 beyond 0.62.
float temperatureAt(const glm::vec3& p) {
    const float away = glm::distance(p, kCorner) / 0.62f;
    return std::max(0.0f, 1.0f - away * away);
}

/// Rounds the cube's corner and lets it run down: hot metal shrinks towards the middle, sinks and ripples.
glm::vec3 sagged(const glm::vec3& p) {
    const float heat = temperatureAt(p);
    const float melt = heat * heat * (3.0f - 2.0f * heat);
    glm::vec3 q = p - 0.20f * melt * glm::normalize(kCorner);
    q.y -= 0.10f * melt;
    q += 0.012f * melt * glm::vec3(std::sin(17 * p.y + 9 * p.z), std::sin(15 * p.x - 8 * p.z), std::cos(16 * p.y));
    // The extracted surface of particles is never quite flat.
    q +=
        0.002f * glm::vec3(std::sin(61 * p.y + 47 * p.z), std::sin(53 * p.x + 59 * p.z), std::sin(57 * p.x + 43 * p.y));
    return q;
}

glm::vec3 faceNormal(int axis, float side) {
    glm::vec3 n(0.0f);
    n[axis] = side;
    return n;
}

struct Mesh {
    std::vector<SurfaceVertex> vertices;
    std::vector<GLuint> indices;
};

/// Returns the normal by differences along the face, rounded towards the edges as a density gradient is.
glm::vec3 normalAt(const glm::vec3& p, int axis, float side) {
    constexpr float step = 0.01f;
    glm::vec3 u(0.0f), v(0.0f);
    u[(axis + 1) % 3] = step;
    v[(axis + 2) % 3] = step;
    const glm::vec3 flat =
        side * glm::normalize(glm::cross(sagged(p + u) - sagged(p - u), sagged(p + v) - sagged(p - v)));
    glm::vec3 rounded(0.0f);
    for (int i = 0; i < 3; ++i)
        rounded[i] = std::copysign(std::pow(std::abs(2 * p[i]), 24.0f), p[i]);
    return glm::normalize(flat + 0.9f * (rounded - faceNormal(axis, side)));
}

void addFace(Mesh& mesh, int axis, float side) {
    const auto first = static_cast<GLuint>(mesh.vertices.size());
    for (int i = 0; i <= kCells; ++i)
        for (int j = 0; j <= kCells; ++j) {
            glm::vec3 p(0.0f);
            p[axis] = 0.5f * side;
            p[(axis + 1) % 3] = static_cast<float>(i) / kCells - 0.5f;
            p[(axis + 2) % 3] = static_cast<float>(j) / kCells - 0.5f;
            mesh.vertices.push_back({sagged(p), temperatureAt(p), normalAt(p, axis, side), 0.0f});
        }
    const GLuint row = kCells + 1;
    for (GLuint i = 0; i < kCells; ++i)
        for (GLuint j = 0; j < kCells; ++j) {
            const GLuint a = first + i * row + j;
            const std::array<GLuint, 6> outward{a, a + row, a + row + 1, a, a + row + 1, a + 1};
            for (size_t k = 0; k < 6; ++k)
                mesh.indices.push_back(outward[side > 0 ? k : 5 - k]);
        }
}

Mesh makeMesh() {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f})
            addFace(mesh, axis, side);
    return mesh;
}

std::vector<glm::vec4> makeParticles() {
    constexpr int n = 16;
    std::vector<glm::vec4> particles;
    for (int i = 0; i < n * n * n; ++i) {
        const glm::vec3 p = (glm::vec3(i % n, i / n % n, i / n / n) + 0.5f) / float(n) - 0.5f;
        particles.emplace_back(sagged(p), temperatureAt(p));
    }
    return particles;
}

} // namespace

SyntheticScene::SyntheticScene() {
    const Mesh mesh = makeMesh();
    const std::vector<glm::vec4> particles = makeParticles();
    const SurfaceDraw draw{static_cast<uint>(mesh.indices.size()), 1, 0, 0, 0};
    vertices_ = mesh.vertices;
    vertexBuffer_ = gl::Buffer("test vertices", std::span<const SurfaceVertex>(mesh.vertices));
    indexBuffer_ = gl::Buffer("test indices", std::span<const GLuint>(mesh.indices));
    command_ = gl::Buffer("test draw command", sizeof draw);
    command_.writeValue(draw);
    particles_ = gl::Buffer("test particles", std::span<const glm::vec4>(particles));
    particleCount_ = particles.size();
}

SceneView SyntheticScene::view() const {
    SceneView scene;
    scene.mesh.vertices = &vertexBuffer_;
    scene.mesh.indices = &indexBuffer_;
    scene.mesh.drawCommand = &command_;
    scene.particles.positions = &particles_;
    scene.particles.count = particleCount_;
    scene.source.shown = true;
    scene.source.on = true;
    scene.source.position = {0.62f, 0.62f, 0.62f};
    return scene;
}

} // namespace meltpool::test
