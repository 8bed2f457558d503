#include "core/weld/gauge/section_map.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace meltpool {

namespace {

constexpr float kTexelsPerSpacing = 8;
constexpr float kMostTexels = 1024;
constexpr float kReach = 1.5F; ///< reach of a particle, spacings
constexpr float kPi = 3.14159265F;
constexpr float kFullWeight = kPi / 3 * kReach * kReach; ///< integral of (1 - r²)² over the plane, spacings squared

/// The range of texels that a row of particles can reach.
struct TexelRange {
    glm::ivec2 first, last;
};

TexelRange reachedTexels(const SectionMap& map, glm::vec2 place, float reach) {
    const glm::vec2 perMetre = glm::vec2(map.texels) / map.size;
    const glm::vec2 middle = (place - map.low) * perMetre;
    const glm::vec2 top(map.texels);
    const glm::vec2 first = glm::clamp(glm::ceil(middle - reach * perMetre - 0.5F), glm::vec2(0), top);
    const glm::vec2 last = glm::clamp(glm::floor(middle + reach * perMetre - 0.5F), glm::vec2(-1), top - 1.0F);
    return {glm::ivec2(first), glm::ivec2(last)};
}

/// The set of lattice cells, seen along the seam, that at least half of the slices fill.
class FilledCells {
  public:
    FilledCells(const SectionMap& map, int slices, const std::vector<MapParticle>& particles)
        : low_(map.low), spacing_(map.spacing), size_(glm::round(map.size / map.spacing)), least_((slices + 1) / 2) {
        counts_.resize(static_cast<size_t>(size_.x) * static_cast<size_t>(size_.y));
        for (const MapParticle& particle : particles)
            if (const glm::ivec2 cell = cellAt(particle.place); particle.onLattice && inside(cell)) ++counts_[at(cell)];
    }

    glm::ivec2 size() const { return size_; }

    /// Returns true for a cell that sticks out between two faces that go on straight for some cells; the cells of a
    /// bevel make steps.
    bool isCorner(glm::ivec2 cell) const {
        for (const int right : {-1, 1})
            for (const int up : {-1, 1})
                if (sticksOut(cell, {right, up})) return true;
        return false;
    }

  private:
    static constexpr int kStraight = 3;

    /// Tests the quadrant `out`, of 1 and -1.
    bool sticksOut(glm::ivec2 cell, glm::ivec2 out) const {
        for (int k = 0; k < kStraight; ++k) {
            const glm::ivec2 along(k * out.x, 0), up(0, k * out.y);
            if (!full(cell - along) || full(cell - along + glm::ivec2(0, out.y))) return false;
            if (!full(cell - up) || full(cell - up + glm::ivec2(out.x, 0))) return false;
        }
        return true;
    }
    glm::ivec2 cellAt(glm::vec2 place) const { return glm::ivec2(glm::floor((place - low_) / spacing_)); }
    bool inside(glm::ivec2 cell) const { return cell.x >= 0 && cell.y >= 0 && cell.x < size_.x && cell.y < size_.y; }
    size_t at(glm::ivec2 cell) const {
        return static_cast<size_t>(cell.y) * static_cast<size_t>(size_.x) + static_cast<size_t>(cell.x);
    }
    bool full(glm::ivec2 cell) const { return inside(cell) && counts_[at(cell)] >= least_; }

    glm::vec2 low_;
    float spacing_;
    glm::ivec2 size_;
    int least_;
    std::vector<int> counts_;
};

/// Marks the cells in the square corners of plates.
void markCorners(SectionMap& map, const FilledCells& cells) {
    const glm::vec2 perCell = glm::vec2(map.texels) / map.size * map.spacing;
    const auto firstTexel = [&](glm::ivec2 cell) {
        return glm::min(glm::ivec2(glm::ceil(glm::vec2(cell) * perCell - 0.5F)), map.texels);
    };
    for (int row = 0; row < cells.size().y; ++row)
        for (int column = 0; column < cells.size().x; ++column) {
            if (!cells.isCorner({column, row})) continue;
            const glm::ivec2 first = firstTexel({column, row}), end = firstTexel({column + 1, row + 1});
            for (int y = first.y; y < end.y; ++y)
                for (int x = first.x; x < end.x; ++x)
                    map.sums[static_cast<size_t>(y) * static_cast<size_t>(map.texels.x) + static_cast<size_t>(x)].w = 1;
        }
}

} // namespace

SectionMap makeSectionMap(glm::vec2 low, glm::vec2 size, float spacing, int slices,
                          const std::vector<MapParticle>& particles) {
    SectionMap map{low, size, glm::ivec2(0), spacing, {}};
    if (slices <= 0) return map;
    const glm::vec2 wanted = glm::ceil(size / spacing * kTexelsPerSpacing);
    const float shrink = std::min(1.0F, kMostTexels / std::max({wanted.x, wanted.y, 1.0F}));
    map.texels = glm::max(glm::ivec2(wanted * shrink), glm::ivec2(1));
    const auto columns = static_cast<size_t>(map.texels.x);
    map.sums.resize(columns * static_cast<size_t>(map.texels.y));
    const glm::vec2 texel = map.size / glm::vec2(map.texels);
    const float reach = kReach * spacing;
    const float share = 1 / (kFullWeight * static_cast<float>(slices));
    for (const MapParticle& particle : particles) {
        const TexelRange range = reachedTexels(map, particle.place, reach);
        for (int y = range.first.y; y <= range.last.y; ++y)
            for (int x = range.first.x; x <= range.last.x; ++x) {
                const glm::vec2 off = (map.low + (glm::vec2(x, y) + 0.5F) * texel - particle.place) / reach;
                const float inside = std::max(1 - glm::dot(off, off), 0.0F);
                const float weight = inside * inside * share;
                map.sums[static_cast<size_t>(y) * columns + static_cast<size_t>(x)] +=
                    weight * glm::vec4(1, particle.peak, particle.temperature, 0);
            }
    }
    markCorners(map, FilledCells(map, slices, particles));
    return map;
}

} // namespace meltpool
