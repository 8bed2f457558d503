#include "core/weld/gauge/weld_section.hpp"

#include "core/base/error.hpp"
#include "core/weld/gauge/section_slice.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

constexpr std::array<glm::ivec2, 2> kSides{{{0, 1}, {1, 0}}}; ///< up, towards the welder
constexpr int kNoRow = -1;

/// The state's particles, read back.
struct Particles {
    Particles(const MetalState& state, size_t originals)
        : positions(state.position.read<vec4>(state.particles())),
          heats(state.heat.read<vec4>(state.particles())),
          phases(state.phase.read<uint>(state.particles())) {
        if (originals > positions.size())
            throw RuntimeFault("a section of a metal with " + std::to_string(positions.size()) +
                               " particles cannot be measured; expected the " + std::to_string(originals) +
                               " of the workpiece among them");
    }

    std::vector<vec4> positions, heats;
    std::vector<uint> phases;
};

/// The row that all columns with a row have in common.
std::optional<int> commonRow(const std::vector<int>& rows) {
    std::optional<int> common;
    for (const int row : rows) {
        if (row == kNoRow) continue;
        if (common && *common != row) return std::nullopt;
        common = row;
    }
    return common;
}

/// The lattice layers that a cut takes and what they hold.
class CutLayers {
  public:
    CutLayers(const MetalLattice& lattice, const SectionCut& cut)
        : lattice_(lattice), spacing_(static_cast<double>(lattice.spacing)) {
        const double cells = static_cast<double>(lattice.cells().x);
        const double low = static_cast<double>(lattice.low.x);
        const double first = std::floor((cut.from + 0.5 * spacing_ - low) / spacing_);
        const double count = std::max(1.0, std::round((cut.to - cut.from) / spacing_));
        first_ = static_cast<int>(std::clamp(first, 0.0, cells));
        const int end = static_cast<int>(std::clamp(first + count, 0.0, cells));
        const glm::ivec2 grid(lattice.cells().z, lattice.cells().y);
        layers_.resize(static_cast<size_t>(std::max(end - first_, 0)), Layer{SectionSlice(grid), 0, 0});
    }

    void enter(const Particles& particles, std::span<const MetalSeed> original, double fusion);
    Section measure(const SectionCut& cut, const SectionMap& map) const;
    SectionMap draw(const Particles& particles) const;

  private:
    struct Layer {
        SectionSlice slice;
        size_t had;   ///< cells that held metal at the start
        size_t holds; ///< particles there now
    };

    /// Number of the layer that a place lies in; nothing outside the cut, or for a layer without workpiece.
    std::optional<size_t> layerOf(const vec4& position) const;
    double rowHeight(int row) const { return static_cast<double>(lattice_.low.y) + row * spacing_; }
    double columnPlace(double column) const { return static_cast<double>(lattice_.low.z) + column * spacing_; }
    WeldZone zoneOf(double kelvin) const;
    int used() const;
    void measureShape(const SectionMap& map, double fusion, Section& section) const;
    double meanRootFusion(glm::ivec2 corner, double fusion) const;

    MetalLattice lattice_;
    double spacing_;
    int first_ = 0;
    std::vector<Layer> layers_;
    std::optional<int> level_; ///< uppermost row of the workpiece where all columns have the same
};

std::optional<size_t> CutLayers::layerOf(const vec4& position) const {
    const double cell =
        std::floor((static_cast<double>(position.x) - static_cast<double>(lattice_.low.x)) / spacing_) - first_;
    if (!(cell >= 0 && cell < static_cast<double>(layers_.size()))) return std::nullopt;
    const auto layer = static_cast<size_t>(cell);
    return layers_[layer].had > 0 ? std::optional(layer) : std::nullopt;
}

void CutLayers::enter(const Particles& particles, std::span<const MetalSeed> original, double fusion) {
    std::vector<int> tops(static_cast<size_t>(lattice_.cells().z), kNoRow); // uppermost row of the workpiece
    for (size_t i = 0; i < original.size(); ++i) {
        const glm::ivec3 cell = lattice_.cellAt(original[i].position);
        const int number = cell.x - first_;
        if (!(original[i].phase & PHASE_LATTICE) || !lattice_.contains(cell) || number < 0 ||
            number >= static_cast<int>(layers_.size()))
            continue;
        Layer& layer = layers_[static_cast<size_t>(number)];
        const auto peak = static_cast<double>(particles.heats[i].z);
        const bool melted = !(particles.phases[i] & PHASE_LATTICE) && peak >= fusion;
        layer.slice.setPeak({cell.z, cell.y}, melted ? SectionSlice::kGone : peak);
        ++layer.had;
        int& top = tops[static_cast<size_t>(cell.z)];
        top = std::max(top, cell.y);
    }
    level_ = commonRow(tops);
    for (size_t i = 0; i < particles.positions.size(); ++i) {
        if (!(particles.phases[i] & PHASE_ALIVE)) continue;
        if (const auto layer = layerOf(particles.positions[i])) ++layers_[*layer].holds;
    }
}

int CutLayers::used() const {
    return static_cast<int>(std::count_if(layers_.begin(), layers_.end(), [](const Layer& l) { return l.had > 0; }));
}

WeldZone CutLayers::zoneOf(double kelvin) const {
    const std::span<const glm::ivec2> sides = std::span(kSides).first(level_ ? 1 : 2);
    WeldZone sum;
    double highest = 0, moment = 0;
    for (const Layer& layer : layers_) {
        if (layer.had == 0) continue;
        const SliceZone zone = measureZone(layer.slice, sides, kelvin);
        sum.width += zone.width * spacing_;
        moment += zone.width * spacing_ * columnPlace(zone.middle);
        sum.depth += zone.depth * spacing_;
        sum.area += zone.area * spacing_ * spacing_;
        if (zone.low.x > zone.high.x) continue;
        sum.box.width += (zone.high.x - zone.low.x) * spacing_;
        const auto low = static_cast<double>(lattice_.low.y);
        sum.box.depth += std::max(-(low + zone.low.y * spacing_), 0.0);
        highest += std::max(low + zone.high.y * spacing_, 0.0);
    }
    const double middle = sum.width > 0 ? moment / sum.width : 0;
    const double layers = std::max(used(), 1);
    for (double* value : {&sum.width, &sum.depth, &sum.area, &sum.box.width, &sum.box.depth})
        *value /= layers;
    sum.box.height = highest / layers;
    if (level_ && sum.width > 0) sum.stretch = {middle - 0.5 * sum.width, middle + 0.5 * sum.width};
    return sum;
}

double CutLayers::meanRootFusion(glm::ivec2 corner, double fusion) const {
    double sum = 0;
    for (const Layer& layer : layers_)
        if (layer.had > 0) sum += rootFusion(layer.slice, corner, fusion) * spacing_;
    return sum / std::max(used(), 1);
}

void CutLayers::measureShape(const SectionMap& map, double fusion, Section& section) const {
    const WeldOutline outline = weldOutline(map);
    double top = 0; // of the deposit over the origin
    if (level_) {
        const double face = rowHeight(*level_ + 1);
        section.bead = measureBead(outline, {{0, face}}, spacing_);
        if (section.bead->height > 0) top = face + section.bead->height;
    } else {
        const auto any = std::find_if(layers_.begin(), layers_.end(), [](const Layer& layer) { return layer.had > 0; });
        const auto corner = jointCorner(any->slice);
        if (!corner) return;
        const glm::dvec2 place(columnPlace(corner->x), rowHeight(corner->y));
        section.fillet = measureFillet(outline, {place}, spacing_);
        section.rootFusion = meanRootFusion(*corner, fusion);
        if (section.fillet) top = place.y + section.fillet->toes[1].place;
    }
    section.fusion.box.height = std::max(section.fusion.box.height, top);
    if (section.heatAffected) section.heatAffected->box.height = std::max(section.heatAffected->box.height, top);
}

Section CutLayers::measure(const SectionCut& cut, const SectionMap& map) const {
    Section section;
    section.layers = used();
    if (section.layers == 0) {
        if (cut.heatAffected) section.heatAffected.emplace();
        return section;
    }
    for (const Layer& layer : layers_)
        if (layer.had > 0)
            section.deposited +=
                (static_cast<double>(layer.holds) - static_cast<double>(layer.had)) * spacing_ * spacing_;
    section.deposited /= section.layers;
    section.fusion = zoneOf(cut.fusion);
    section.fusion.box.area = section.fusion.area + section.deposited;
    if (cut.heatAffected) {
        section.heatAffected = zoneOf(*cut.heatAffected);
        section.heatAffected->box.area = section.heatAffected->area + section.deposited;
    }
    measureShape(map, cut.fusion, section);
    return section;
}

SectionMap CutLayers::draw(const Particles& particles) const {
    std::vector<MapParticle> near;
    for (size_t i = 0; i < particles.positions.size(); ++i) {
        const vec4& at = particles.positions[i];
        if (!(particles.phases[i] & PHASE_ALIVE) || !layerOf(at) || !std::isfinite(at.y) || !std::isfinite(at.z))
            continue;
        near.push_back({{at.z, at.y}, std::max(particles.heats[i].z, at.w), at.w});
    }
    const glm::vec2 size = glm::vec2(lattice_.cells().z, lattice_.cells().y) * lattice_.spacing;
    return makeSectionMap({lattice_.low.z, lattice_.low.y}, size, lattice_.spacing, used(), near);
}

} // namespace

SectionCut sectionCut(const Material& material, double from, double to) {
    SectionCut cut;
    cut.from = from;
    cut.to = to;
    cut.fusion = 0.5 * (material.solidus + material.liquidus);
    if (cut.fusion > kSteelTransformation) cut.heatAffected = kSteelTransformation;
    return cut;
}

WeldSection cutWeld(const MetalState& state, std::span<const MetalSeed> original, const SectionCut& cut) {
    const Particles particles(state, original.size());
    CutLayers layers(state.lattice(), cut);
    layers.enter(particles, original, cut.fusion);
    WeldSection section{cut, {}, layers.draw(particles)};
    section.figures = layers.measure(cut, section.map);
    return section;
}

Section measureSection(const MetalState& state, std::span<const MetalSeed> original, const SectionCut& cut) {
    return cutWeld(state, original, cut).figures;
}

double middleOfWeld(const MetalState& state, std::span<const MetalSeed> original, double fusion) {
    const Particles particles(state, original.size());
    constexpr float kFar = std::numeric_limits<float>::max();
    float low = kFar, high = -kFar, fusedLow = kFar, fusedHigh = -kFar;
    for (size_t i = 0; i < original.size(); ++i) {
        const float x = original[i].position.x;
        low = std::min(low, x);
        high = std::max(high, x);
        if (static_cast<double>(particles.heats[i].z) < fusion) continue;
        fusedLow = std::min(fusedLow, x);
        fusedHigh = std::max(fusedHigh, x);
    }
    if (fusedLow <= fusedHigh) return 0.5 * static_cast<double>(fusedLow + fusedHigh);
    return low <= high ? 0.5 * static_cast<double>(low + high) : 0;
}

} // namespace meltpool
