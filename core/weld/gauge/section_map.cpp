#include "core/weld/gauge/section_map.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace meltpool {

namespace {

constexpr float kTexelsPerSpacing = 8;
constexpr float kMostTexels = 1024;
constexpr float kReach = 1.5F; ///< of a particle, spacings
constexpr float kPi = 3.14159265F;
constexpr float kFullWeight = kPi / 3 * kReach * kReach; ///< integral of (1 - r²)² over the plane, spacings squared

/// The texels that a row of particles can reach.
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
    return map;
}

} // namespace meltpool
