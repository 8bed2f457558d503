#include "tests/surface/surface_twin.hpp"

#include "core/surface/cell_cases.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace meltpool::test {

using glm::ivec3;
using glm::vec3;

namespace {

vec3 placeInGrid(const SurfaceSetup& s, const glm::vec4& particle) {
    return (vec3(particle) - s.origin) * (vec3(s.cells) / s.extent) + 1.0f;
}

bool isOwn(const SurfaceGrid& grid, ivec3 corner) {
    return glm::all(glm::greaterThanEqual(corner, ivec3(1))) && glm::all(glm::lessThanEqual(corner, grid.cells + 1));
}

/// Density and heat of the grid's corners; 0 in the layer around it.
struct Field {
    const SurfaceGrid& grid;
    const Volumes& volumes;

    float density(ivec3 corner) const {
        return isOwn(grid, corner) ? float(volumes.density[grid.address(corner)]) : 0.0f;
    }
    float heat(ivec3 corner) const { return float(volumes.temperature[grid.address(corner)]); }

    vec3 gradient(ivec3 corner) const {
        vec3 slope(0.0f);
        for (int axis = 0; axis < 3; ++axis) {
            ivec3 after = corner, before = corner;
            after[axis] = std::min(corner[axis] + 1, grid.cells[axis] + 1);
            before[axis] = std::max(corner[axis] - 1, 1);
            slope[axis] = (density(after) - density(before)) / float(after[axis] - before[axis]);
        }
        return slope;
    }
};

/// Returns the vertex between two neighbouring corners of which one is inside.
SurfaceVertex vertexBetween(const Field& field, float iso, ivec3 a, ivec3 b, float coldest, float hottest) {
    const SurfaceSetup s = field.grid.setup();
    const bool cap = !isOwn(field.grid, a) || !isOwn(field.grid, b);
    const vec3 axis = vec3(b - a) * glm::sign(s.extent) * (field.density(a) > field.density(b) ? 1.0f : -1.0f);
    if (cap) (isOwn(field.grid, a) ? b : a) = isOwn(field.grid, a) ? a : b;
    const float atA = field.density(a), atB = field.density(b);
    const float part = cap ? 0.0f : glm::clamp((iso - atA) / (atB - atA), 0.0f, 1.0f);
    const vec3 place = glm::mix(vec3(a), vec3(b), part) - 1.0f;
    const float share = glm::mix(field.heat(a), field.heat(b), part) / glm::mix(atA, atB, part);
    const vec3 rise = glm::mix(field.gradient(a), field.gradient(b), part) * vec3(s.cells) / s.extent;
    SurfaceVertex vertex{};
    vertex.position = s.origin + s.extent * place / vec3(s.cells);
    vertex.temperature = coldest + (hottest - coldest) * share;
    vertex.normal = cap || rise == vec3(0.0f) ? axis : -glm::normalize(rise);
    return vertex;
}

} // namespace

namespace {

float weightOf(SurfaceKernel kernel, int influence, float square) {
    const float reach = float(influence - 1);
    if (kernel == SurfaceKernel::cone) return 1.0f - std::sqrt(square) * (1.0f / (0.8660254f + 1.7320508f * reach));
    const float inner = std::max(1.0f - square * (1.0f / ((reach + 0.5f) * (reach + 0.5f))), 0.0f);
    return inner * inner * inner;
}

} // namespace

Volumes twinVolumes(const SurfaceGrid& grid, const SurfaceParameters& parameters, float coldest, float hottest,
                    const std::vector<glm::vec4>& particles) {
    const SurfaceSetup s = grid.setup();
    Volumes volumes;
    volumes.density.resize(grid.blockCount() * SURFACE_BLOCK_CORNERS);
    volumes.temperature.resize(volumes.density.size());
    const int reach = parameters.influence - 1;
    for (const glm::vec4& particle : particles) {
        const vec3 place = placeInGrid(s, particle);
        if (!(std::abs(place.x) < 1e6f && std::abs(place.y) < 1e6f && std::abs(place.z) < 1e6f)) continue;
        const float raw = (particle.w - coldest) / (hottest - coldest);
        const float share = raw > 0.0f ? std::min(raw, 1.0f) : 0.0f;
        const ivec3 nearest(glm::floor(place + 0.5f));
        for (int z = nearest.z - reach; z <= nearest.z + reach; ++z)
            for (int y = nearest.y - reach; y <= nearest.y + reach; ++y)
                for (int x = nearest.x - reach; x <= nearest.x + reach; ++x) {
                    const vec3 d = place - vec3(ivec3(x, y, z));
                    const float value = weightOf(static_cast<SurfaceKernel>(parameters.kernel), parameters.influence,
                                                 d.x * d.x + (d.y * d.y + d.z * d.z));
                    if (!isOwn(grid, {x, y, z}) || value <= 0.0f) continue;
                    const auto weight = static_cast<std::uint32_t>(value * float(SURFACE_UNIT) + 0.5f);
                    volumes.density[grid.address({x, y, z})] += weight;
                    volumes.temperature[grid.address({x, y, z})] +=
                        static_cast<std::uint32_t>(float(weight) * share + 0.5f);
                }
    }
    return volumes;
}

std::vector<glm::uvec2> twinFreezing(const SurfaceGrid& grid, const SurfaceParameters& parameters,
                                     const std::vector<glm::vec4>& particles, const std::vector<float>& frozenAt) {
    const SurfaceSetup s = grid.setup();
    const int reach = parameters.influence - 1, across = 2 * reach + 1;
    const float unit = float(std::min(64, 8000 / (across * across * across)));
    std::vector<glm::uvec2> volume(grid.blockCount() * SURFACE_BLOCK_CORNERS, glm::uvec2(0));
    for (size_t i = 0; i < particles.size(); ++i) {
        if (frozenAt[i] == 0) continue;
        const bool frozen = frozenAt[i] > 0 && frozenAt[i] < 2048.0f;
        const unsigned ticks = frozen ? static_cast<unsigned>(frozenAt[i] * 512.0f + 0.5f) : 0;
        const vec3 place = placeInGrid(s, particles[i]);
        const ivec3 nearest(glm::floor(place + 0.5f));
        for (int z = nearest.z - reach; z <= nearest.z + reach; ++z)
            for (int y = nearest.y - reach; y <= nearest.y + reach; ++y)
                for (int x = nearest.x - reach; x <= nearest.x + reach; ++x) {
                    const vec3 d = place - vec3(ivec3(x, y, z));
                    const float value = weightOf(static_cast<SurfaceKernel>(parameters.kernel), parameters.influence,
                                                 d.x * d.x + (d.y * d.y + d.z * d.z));
                    if (!isOwn(grid, {x, y, z}) || value <= 0.0f) continue;
                    const auto weight = static_cast<unsigned>(value * unit + 0.5f);
                    volume[grid.address({x, y, z})] +=
                        glm::uvec2(65536u * weight + (frozen ? weight : 0), weight * ticks);
                }
    }
    return volume;
}

namespace {

/// Edges in the order of the vertices: by row of 8 corners, then axis, then corner.
using EdgeOrder = std::array<size_t, 3>;

struct TwinTriangle {
    size_t cell;
    std::array<EdgeOrder, 3> edges;
};

} // namespace

Mesh twinMesh(const SurfaceGrid& grid, const Volumes& volumes, const SurfaceParameters& parameters, float coldest,
              float hottest) {
    const Field field{grid, volumes};
    const float iso = float(std::lround(double(parameters.isoLevel) * SURFACE_UNIT));
    const int first = parameters.caps ? 0 : 1;
    const ivec3 last = grid.cells + (parameters.caps ? 1 : 0);
    std::map<EdgeOrder, SurfaceVertex> vertices;
    std::vector<TwinTriangle> triangles;
    for (int z = first; z <= last.z; ++z)
        for (int y = first; y <= last.y; ++y)
            for (int x = first; x <= last.x; ++x) {
                const ivec3 cell(x, y, z);
                unsigned inside = 0;
                for (unsigned i = 0; i < 8; ++i)
                    inside |= unsigned(field.density(cell + ivec3(i & 1, i >> 1 & 1, i >> 2)) >= iso) << i;
                for (const CellTriangle& t : cellTriangles(inside)) {
                    TwinTriangle triangle{grid.address(cell), {}};
                    for (size_t i = 0; i < 3; ++i) {
                        const CellEdge edge = t[(3 - i) % 3]; // reversed, because z runs against the model's
                        const ivec3 a = cell + ivec3(edge & 1, edge >> 1 & 1, edge >> 2 & 1);
                        ivec3 b = a;
                        ++b[static_cast<int>(edge >> 3)];
                        triangle.edges[i] = {grid.address(a) / SURFACE_BLOCK, edge >> 3, size_t(a.x)};
                        vertices.emplace(triangle.edges[i], vertexBetween(field, iso, a, b, coldest, hottest));
                    }
                    triangles.push_back(triangle);
                }
            }
    std::stable_sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
    Mesh mesh;
    std::map<EdgeOrder, unsigned> numbers;
    for (const auto& [edge, vertex] : vertices) {
        numbers.emplace(edge, static_cast<unsigned>(mesh.vertices.size()));
        mesh.vertices.push_back(vertex);
    }
    for (const TwinTriangle& triangle : triangles)
        for (const EdgeOrder& edge : triangle.edges)
            mesh.indices.push_back(numbers.at(edge));
    return mesh;
}

Mesh readMesh(const Surface& surface) {
    const auto draw = surface.mesh().drawCommand->read<SurfaceDraw>(1).front();
    Mesh mesh;
    mesh.vertices = surface.mesh().vertices->read<SurfaceVertex>(
        std::min<size_t>(surface.statistics().vertices, surface.grid().mostVertices()));
    const auto indices = surface.mesh().indices->read<unsigned>(draw.count);
    for (size_t i = 0; i < indices.size(); i += 3)
        if (indices[i] != indices[i + 1]) mesh.indices.insert(mesh.indices.end(), &indices[i], &indices[i] + 3);
    return mesh;
}

std::vector<std::pair<unsigned, unsigned>> unmatchedSides(const Mesh& mesh) {
    std::vector<std::pair<unsigned, unsigned>> sides;
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const size_t next = i % 3 == 2 ? i - 2 : i + 1;
        sides.emplace_back(mesh.indices[i], mesh.indices[next]);
    }
    std::sort(sides.begin(), sides.end());
    std::vector<std::pair<unsigned, unsigned>> wrong;
    for (size_t i = 0; i < sides.size(); ++i) {
        const bool repeated = (i > 0 && sides[i - 1] == sides[i]) || (i + 1 < sides.size() && sides[i + 1] == sides[i]);
        const std::pair<unsigned, unsigned> reverse{sides[i].second, sides[i].first};
        if (repeated || !std::binary_search(sides.begin(), sides.end(), reverse)) wrong.push_back(sides[i]);
    }
    return wrong;
}

namespace {

template <class Measure>
double sumTriangles(const Mesh& mesh, Measure measure) {
    double sum = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
        sum += measure(glm::dvec3(mesh.vertices[mesh.indices[i]].position),
                       glm::dvec3(mesh.vertices[mesh.indices[i + 1]].position),
                       glm::dvec3(mesh.vertices[mesh.indices[i + 2]].position));
    return sum;
}

} // namespace

double meshArea(const Mesh& mesh) {
    return sumTriangles(
        mesh, [](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return glm::length(glm::cross(b - a, c - a)) / 2; });
}

double meshVolume(const Mesh& mesh) {
    return sumTriangles(mesh,
                        [](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return glm::dot(a, glm::cross(b, c)) / 6; });
}

} // namespace meltpool::test
