#include "core/weld/gauge/weld_outline.hpp"

#include <array>
#include <cmath>

namespace meltpool {

namespace {

constexpr float kEdge = 0.5F; ///< weight at the edge of the metal
constexpr int kNone = -1;
constexpr size_t kSides = 4;

/// The texels' centres as nodes of a grid with a ring of empty nodes around it, so that every edge closes.
class NodeGrid {
  public:
    explicit NodeGrid(const SectionMap& map) : map_(map), nodes_(map.texels + 2) {}

    glm::ivec2 squares() const { return nodes_ - 1; }
    size_t edges() const { return 2 * static_cast<size_t>(nodes_.x) * static_cast<size_t>(nodes_.y); }
    bool metal(glm::ivec2 node) const { return weight(node) >= kEdge; }
    /// Returns the mean weight of the four nodes of a square.
    float meanWeight(glm::ivec2 square) const {
        return 0.25F * (weight(square) + weight(square + glm::ivec2(1, 0)) + weight(square + glm::ivec2(0, 1)) +
                        weight(square + 1));
    }
    /// Returns the number of side `side` of a square: below, right, above, left.
    int edge(glm::ivec2 square, size_t side) const {
        const glm::ivec2 from = square + glm::ivec2(side == 1, side == 2);
        return 2 * (from.y * nodes_.x + from.x) + static_cast<int>(side % 2);
    }
    /// Returns the place on an edge at which the metal ends, m.
    glm::dvec2 crossing(int edge) const {
        const glm::ivec2 from(edge / 2 % nodes_.x, edge / 2 / nodes_.x);
        const glm::ivec2 to = from + (edge % 2 == 0 ? glm::ivec2(1, 0) : glm::ivec2(0, 1));
        const double share = static_cast<double>((kEdge - weight(from)) / (weight(to) - weight(from)));
        const glm::dvec2 place = glm::dvec2(from) + share * glm::dvec2(to - from) - 0.5; // place in texels
        return glm::dvec2(map_.low) + place * glm::dvec2(map_.size) / glm::dvec2(map_.texels);
    }

  private:
    float weight(glm::ivec2 node) const {
        const glm::ivec2 texel = node - 1;
        if (texel.x < 0 || texel.y < 0 || texel.x >= map_.texels.x || texel.y >= map_.texels.y) return 0;
        return map_
            .sums[static_cast<size_t>(texel.y) * static_cast<size_t>(map_.texels.x) + static_cast<size_t>(texel.x)]
            .x;
    }

    const SectionMap& map_;
    glm::ivec2 nodes_;
};

/// Marching squares: enters the pieces of edge in one square as links from the side at which a walk around the square
/// leaves the metal to the side at which the walk enters it again.
void link(const NodeGrid& grid, glm::ivec2 square, std::vector<int>& next) {
    constexpr std::array<glm::ivec2, kSides> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::array<bool, kSides> in{};
    for (size_t i = 0; i < kSides; ++i)
        in[i] = grid.metal(square + kCorners[i]);
    const bool saddle = in[0] == in[2] && in[1] == in[3] && in[0] != in[1];
    const bool joined = saddle && grid.meanWeight(square) >= kEdge;
    for (size_t side = 0; side < kSides; ++side) {
        if (!in[side] || in[(side + 1) % kSides]) continue;
        size_t entry = (side + (saddle && !joined ? kSides - 1 : 1)) % kSides;
        while (in[entry] || !in[(entry + 1) % kSides])
            entry = (entry + 1) % kSides;
        next[static_cast<size_t>(grid.edge(square, side))] = grid.edge(square, entry);
    }
}

} // namespace

double areaInside(std::span<const glm::dvec2> line) {
    double twice = 0;
    for (size_t i = 0; i < line.size(); ++i) {
        const glm::dvec2 a = line[i], b = line[(i + 1) % line.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

WeldOutline weldOutline(const SectionMap& map) {
    if (map.sums.empty()) return {};
    const NodeGrid grid(map);
    std::vector<int> next(grid.edges(), kNone);
    for (int y = 0; y < grid.squares().y; ++y)
        for (int x = 0; x < grid.squares().x; ++x)
            link(grid, {x, y}, next);
    WeldOutline largest;
    double most = 0;
    for (int& start : next) {
        WeldOutline line;
        for (int* at = &start; *at != kNone;) {
            const int edge = *at;
            *at = kNone;
            line.push_back(grid.crossing(edge));
            at = &next[static_cast<size_t>(edge)];
        }
        const double area = areaInside(line); // area, negative around a pore
        if (area > most) {
            most = area;
            largest = std::move(line);
        }
    }
    return largest;
}

} // namespace meltpool
