#include "core/validation/arc_landing.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

/// The cells of a box of the lattice: the metal in each, in particles, and its mean temperature.
class CellMetal {
  public:
    CellMetal(const MetalLattice& lattice, const ParticleValues& metal, glm::vec3 low, glm::vec3 high)
        : lattice_(lattice), low_(lattice.cellAt(low)), size_(lattice.cellAt(high) - low_ + 1) {
        const auto count = static_cast<size_t>(size_.x) * static_cast<size_t>(size_.y) * static_cast<size_t>(size_.z);
        weights_.resize(count);
        warmth_.resize(count);
        for (size_t slot = 0; slot < metal.positions.size(); ++slot)
            if (metal.phases[slot] & PHASE_ALIVE) add(metal.positions[slot], metal.phases[slot]);
    }

    glm::ivec3 low() const { return low_; }
    glm::ivec3 size() const { return size_; }
    double weight(glm::ivec3 cell) const { return inside(cell) ? weights_[index(cell)] : 0; }
    double temperature(glm::ivec3 cell) const { return warmth_[index(cell)] / weights_[index(cell)]; }

  private:
    bool inside(glm::ivec3 cell) const {
        const glm::ivec3 at = cell - low_;
        return glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, size_));
    }
    size_t index(glm::ivec3 cell) const {
        const glm::ivec3 at = cell - low_;
        return static_cast<size_t>((at.z * size_.y + at.y) * size_.x + at.x);
    }
    void put(glm::ivec3 cell, double weight, double temperature) {
        if (!inside(cell)) return;
        weights_[index(cell)] += weight;
        warmth_[index(cell)] += weight * temperature;
    }
    /// A particle of the lattice belongs to its cell, another one to the eight cells around it.
    void add(const vec4& particle, uint phase) {
        const glm::dvec3 place = glm::dvec3(glm::vec3(particle) - lattice_.low) / static_cast<double>(lattice_.spacing);
        const auto temperature = static_cast<double>(particle.w);
        if (phase & PHASE_LATTICE) return put(glm::ivec3(glm::floor(place)), 1, temperature);
        const glm::dvec3 base = glm::floor(place - 0.5), part = place - 0.5 - base;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 bit(corner & 1, (corner >> 1) & 1, corner >> 2);
            const glm::dvec3 share = glm::mix(1.0 - part, part, glm::dvec3(bit));
            put(glm::ivec3(base) + bit, share.x * share.y * share.z, temperature);
        }
    }

    const MetalLattice& lattice_;
    glm::ivec3 low_, size_;
    std::vector<double> weights_, warmth_;
};

/// See free_surface.glsl.
double fullness(double weight) {
    return std::clamp((weight - 0.15) / 0.5, 0.0, 1.0);
}

struct Surface {
    glm::dvec3 normal{0};
    double area = 0; ///< in squares of the spacing
};

Surface freeSurface(const CellMetal& cells, glm::ivec3 cell) {
    const double own = fullness(cells.weight(cell));
    glm::dvec3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 step(0);
        step[axis] = 1;
        low[axis] = std::max(0.0, own - fullness(cells.weight(cell - step)));
        high[axis] = std::max(0.0, own - fullness(cells.weight(cell + step)));
    }
    const glm::dvec3 normal = high - low;
    const double size = glm::length(normal);
    return {size > 0 ? normal / size : glm::dvec3(0), glm::length(high + low)};
}

/// See shareInFront() of source.glsl; lengths in spacings.
double shareInFront(const HeatSource& source, double spacing, double depth, double off) {
    constexpr double kSteepest = 2;
    const double before = depth + static_cast<double>(source.before) / spacing;
    const double beyond = static_cast<double>(source.beyond) / spacing + kSteepest * off - depth;
    return std::clamp(before + 0.5, 0.0, 1.0) * std::clamp(beyond + 0.5, 0.0, 1.0);
}

/// Weight of a cell for a Gaussian, m².
double cellWeight(const HeatSource& source, glm::vec3 centre, const Surface& surface, double spacing) {
    const glm::dvec3 away = glm::dvec3(centre - source.position), axis(source.axis);
    const double depth = glm::dot(away, axis), off2 = std::max(0.0, glm::dot(away, away) - depth * depth);
    const auto sigma = static_cast<double>(source.size);
    return surface.area * spacing * spacing * std::max(0.0, -glm::dot(surface.normal, axis)) *
           std::exp(-off2 / (2 * sigma * sigma)) *
           shareInFront(source, spacing, depth / spacing, std::sqrt(off2) / spacing);
}

/// Foremost place of liquid along the seam within `reach` of the source; its own place without liquid.
double foremostLiquid(const ParticleValues& metal, const HeatSource& source) {
    double foremost = -std::numeric_limits<double>::infinity();
    for (size_t slot = 0; slot < metal.positions.size(); ++slot) {
        const bool liquid = (metal.phases[slot] & PHASE_ALIVE) && (metal.phases[slot] & PHASE_LIQUID);
        const bool near = glm::distance(glm::vec3(metal.positions[slot]), source.position) < source.reach();
        if (liquid && near) foremost = std::max(foremost, static_cast<double>(metal.positions[slot].x));
    }
    return std::isfinite(foremost) ? foremost : static_cast<double>(source.position.x);
}

} // namespace

ArcLanding arcLanding(const MetalLattice& lattice, const ParticleValues& metal, const HeatSource& source,
                      double solidus, bool butt) {
    const auto spacing = static_cast<double>(lattice.spacing);
    const glm::vec3 reach(source.reach() + 2 * lattice.spacing);
    const CellMetal cells(lattice, metal, source.position - reach, source.position + reach);
    const double front = foremostLiquid(metal, source);
    ArcLanding landing;
    double total = 0;
    for (int z = 1; z + 1 < cells.size().z; ++z)
        for (int y = 1; y + 1 < cells.size().y; ++y)
            for (int x = 1; x + 1 < cells.size().x; ++x) {
                const glm::ivec3 cell = cells.low() + glm::ivec3(x, y, z);
                if (cells.weight(cell) <= 0) continue;
                const glm::vec3 centre = lattice.centre(cell);
                const double weight = cellWeight(source, centre, freeSurface(cells, cell), spacing);
                total += weight;
                if (cells.temperature(cell) >= solidus) continue;
                landing.solid += weight;
                if (static_cast<double>(centre.x) > front) landing.ahead += weight;
                (butt ? centre.z > 0 : centre.y > 0 && centre.z < 0) ? landing.standing += weight
                                                                     : landing.lying += weight;
            }
    if (total <= 0) return {};
    landing.caught = std::min(1.0, total / std::max(total, static_cast<double>(source.fullWeight)));
    for (double* share : {&landing.solid, &landing.ahead, &landing.lying, &landing.standing})
        *share /= total;
    return landing;
}

namespace {

/// A row of surface cells along a face, in one layer along the seam.
struct Row {
    double line = -std::numeric_limits<double>::infinity(); ///< m from the corner: outermost liquid on the face
    std::vector<std::pair<double, double>> plate;           ///< m from the corner, K, of the plate's outermost cells
};

/// Temperature of a row at `at` (m from the corner), linear between cells.
std::optional<double> warmthAt(Row& row, double at) {
    std::sort(row.plate.begin(), row.plate.end());
    for (size_t i = 1; i < row.plate.size(); ++i)
        if (row.plate[i].first >= at && row.plate[i - 1].first <= at) {
            const auto& [from, cold] = row.plate[i - 1];
            const auto& [to, warm] = row.plate[i];
            return std::lerp(cold, warm, (at - from) / std::max(to - from, 1e-9));
        }
    return std::nullopt;
}

/// Takes a particle into a face's row: `along` and `over` the face from the corner, m.
void take(Row& row, double along, double over, double spacing, uint phase, double temperature) {
    if (along < 0) return;
    if ((phase & PHASE_LIQUID) && over > 0 && over < 1.5 * spacing) row.line = std::max(row.line, along);
    if ((phase & PHASE_LATTICE) && over < 0 && over > -spacing) row.plate.emplace_back(along, temperature);
}

} // namespace

LineWarmth lineWarmth(const MetalLattice& lattice, const ParticleValues& metal, double low, double high,
                      double before) {
    const auto spacing = static_cast<double>(lattice.spacing);
    const auto layers = static_cast<size_t>(std::max(std::ceil((high - low) / spacing), 1.0));
    std::vector<Row> lying(layers), standing(layers);
    for (size_t slot = 0; slot < metal.positions.size(); ++slot) {
        const uint phase = metal.phases[slot];
        const glm::dvec4 place(metal.positions[slot]);
        const double layer = std::floor((place.x - low) / spacing);
        if (!(phase & PHASE_ALIVE) || layer < 0 || layer >= static_cast<double>(layers)) continue;
        take(lying[static_cast<size_t>(layer)], place.z, place.y, spacing, phase, place.w);
        take(standing[static_cast<size_t>(layer)], place.y, place.z, spacing, phase, place.w);
    }
    const auto mean = [&](std::vector<Row>& rows) -> std::optional<double> {
        double sum = 0, count = 0;
        for (Row& row : rows)
            if (std::isfinite(row.line))
                if (const auto warmth = warmthAt(row, row.line + 0.5 * spacing + before)) {
                    sum += *warmth;
                    ++count;
                }
        return count > 0 ? std::optional(sum / count) : std::nullopt;
    };
    return {mean(lying), mean(standing)};
}

} // namespace meltpool
