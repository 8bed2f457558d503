#include "core/surface/mesh_bodies.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace meltpool {

namespace {

using Triangle = std::array<glm::dvec3, 3>;

Triangle triangleAt(const MeshCopy& mesh, size_t firstIndex) {
    const auto corner = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[firstIndex + i]].position); };
    return {corner(0), corner(1), corner(2)};
}

/// Sets of connected vertices (Tarjan's union by index with halved paths). The root of a set is its lowest vertex.
class Sets {
  public:
    explicit Sets(size_t vertices) : above_(vertices) { std::iota(above_.begin(), above_.end(), 0U); }
    std::uint32_t root(std::uint32_t vertex) {
        while (above_[vertex] != vertex)
            vertex = above_[vertex] = above_[above_[vertex]];
        return vertex;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        above_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> above_;
};

/// A connected part of the mesh.
struct Part {
    std::vector<size_t> triangles; ///< the index of each triangle's first corner
    double volume = 0;             ///< enclosed volume, signed
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
};

void addTriangle(Part& part, const MeshCopy& mesh, size_t firstIndex) {
    const Triangle t = triangleAt(mesh, firstIndex);
    part.triangles.push_back(firstIndex);
    part.volume += glm::dot(t[0], glm::cross(t[1], t[2])) / 6;
    for (const glm::dvec3& corner : t) {
        part.low = glm::min(part.low, corner);
        part.high = glm::max(part.high, corner);
    }
}

/// Returns the parts in the order of their first triangles.
std::vector<Part> partsOf(const MeshCopy& mesh) {
    Sets sets(mesh.vertices.size());
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        sets.join(mesh.indices[i], mesh.indices[i + 1]);
        sets.join(mesh.indices[i], mesh.indices[i + 2]);
    }
    constexpr size_t kNone = std::numeric_limits<size_t>::max();
    std::vector<size_t> numbers(mesh.vertices.size(), kNone); // number of each part, by root
    std::vector<Part> parts;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        size_t& number = numbers[sets.root(mesh.indices[i])];
        if (number == kNone) {
            number = parts.size();
            parts.emplace_back();
        }
        addTriangle(parts[number], mesh, i);
    }
    return parts;
}

/// Returns true if the side from a to b crosses the line from (y, z) towards growing y. Both triangles at a side
/// compute one result, whichever way round they go, so that a ray never slips between them or counts both.
bool crosses(glm::dvec3 a, glm::dvec3 b, const glm::dvec3& from) {
    if ((a.z > from.z) == (b.z > from.z)) return false;
    if (a.z > b.z) std::swap(a, b);
    return a.y + (b.y - a.y) * ((from.z - a.z) / (b.z - a.z)) > from.y;
}

/// Returns the place at which the line through `from` along x meets the triangle, seen from `from`, and its direction
/// there: out of the body (+1) or into it (-1).
std::optional<std::pair<double, int>> meeting(const Triangle& t, const glm::dvec3& from) {
    const bool covers = crosses(t[0], t[1], from) ^ crosses(t[1], t[2], from) ^ crosses(t[2], t[0], from);
    const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
    if (!covers || n.x == 0) return std::nullopt;
    return std::pair(glm::dot(n, t[0] - from) / n.x, n.x > 0 ? 1 : -1);
}

/// Returns true if a point is inside the part's enclosed space: a ray along +x leaves it once more than it enters it.
bool encloses(const Part& part, const MeshCopy& mesh, const glm::dvec3& point) {
    int left = 0;
    for (const size_t first : part.triangles)
        if (const auto met = meeting(triangleAt(mesh, first), point); met && met->first > 0) left += met->second;
    return left > 0;
}

/// Returns true if `inner` is inside `outer`. Their surfaces do not cross, so one place of it decides; the middle of a
/// triangle is on no line of the grid.
bool liesIn(const Part& inner, const Part& outer, const MeshCopy& mesh) {
    if (!glm::all(glm::greaterThanEqual(inner.low, outer.low)) || !glm::all(glm::lessThanEqual(inner.high, outer.high)))
        return false;
    const Triangle t = triangleAt(mesh, inner.triangles.front());
    return encloses(outer, mesh, (t[0] + t[1] + t[2]) / 3.0);
}

/// Returns the mesh of these parts alone.
MeshCopy meshOf(const std::vector<Part>& parts, const MeshCopy& mesh) {
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> numbers(mesh.vertices.size(), kUnused);
    MeshCopy kept;
    for (const Part& part : parts)
        for (const size_t first : part.triangles)
            for (size_t i = first; i < first + 3; ++i) {
                const std::uint32_t vertex = mesh.indices[i];
                if (numbers[vertex] == kUnused) {
                    numbers[vertex] = static_cast<std::uint32_t>(kept.vertices.size());
                    kept.vertices.push_back(mesh.vertices[vertex]);
                    if (!mesh.peaks.empty()) kept.peaks.push_back(mesh.peaks[vertex]);
                }
                kept.indices.push_back(numbers[vertex]);
            }
    return kept;
}

} // namespace

MeshCopy outerBodies(const MeshCopy& mesh) {
    std::vector<Part> parts = partsOf(mesh);
    std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.volume > b.volume; });
    std::vector<Part> bodies;
    for (Part& part : parts) {
        if (part.volume <= 0) break; // the parts from here on are walls of hollows
        const auto holds = [&](const Part& larger) { return liesIn(part, larger, mesh); };
        if (std::none_of(bodies.begin(), bodies.end(), holds)) bodies.push_back(std::move(part));
    }
    return meshOf(bodies, mesh);
}

size_t countParts(const MeshCopy& mesh) {
    return partsOf(mesh).size();
}

} // namespace meltpool
