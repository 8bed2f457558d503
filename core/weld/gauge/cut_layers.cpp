#include "core/weld/gauge/cut_layers.hpp"

#include "core/weld/gauge/weld_faults.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace meltpool {

namespace {

constexpr std::array<glm::ivec2, 2> kSides{{{0, 1}, {1, 0}}}; ///< directions up and towards the welder
constexpr int kNoRow = -1;
constexpr int kLeastHole = 2;         ///< adjacent columns without metal that make a hole
constexpr float kCooled = 773.15F;    ///< K, 500 °C: colder metal has its whole cooling time
constexpr double kCooledShare = 0.95; ///< share of the molten metal that must be below kCooled

/// Returns the row of a level surface, from the uppermost rows of the columns: the row of the outermost columns, if
/// they agree and no column is higher. Bevelled edges in between are lower.
std::optional<int> levelOf(const std::vector<int>& tops) {
    const auto isThere = [](int row) { return row != kNoRow; };
    const auto first = std::find_if(tops.begin(), tops.end(), isThere);
    if (first == tops.end()) return std::nullopt;
    const int last = *std::find_if(tops.rbegin(), tops.rend(), isThere);
    if (*first != last || *std::max_element(tops.begin(), tops.end()) > last) return std::nullopt;
    return last;
}

/// Returns the outermost two columns that held metal at the start; the first is above the second if there are none.
glm::ivec2 heldColumns(const SectionSlice& slice) {
    glm::ivec2 ends(slice.cells().x, -1);
    for (int x = 0; x < slice.cells().x; ++x)
        for (int y = 0; y < slice.cells().y; ++y)
            if (slice.held({x, y})) ends = {std::min(ends.x, x), x};
    return ends;
}

/// Returns the unfused heights of the edges on both sides of `seam`, which is the column right of it; cells.
std::optional<glm::dvec2> unfusedBeside(const SectionSlice& slice, int seam, double level) {
    glm::dvec2 unfused(0);
    for (const int side : {0, 1}) {
        const auto height = unfusedEdge(slice, seam, 2 * side - 1, level);
        if (!height) return std::nullopt;
        unfused[side] = *height;
    }
    return unfused;
}

} // namespace

CutLayers::CutLayers(const WeldParticles& particles, const SectionCut& cut)
    : particles_(particles), cut_(cut), lattice_(particles.lattice()), spacing_(static_cast<double>(lattice_.spacing)) {
    const double cells = static_cast<double>(lattice_.cells().x);
    const double low = static_cast<double>(lattice_.low.x);
    const double first = std::floor((cut.from + 0.5 * spacing_ - low) / spacing_);
    const double count = std::max(1.0, std::round((cut.to - cut.from) / spacing_));
    first_ = static_cast<int>(std::clamp(first, 0.0, cells));
    const int end = static_cast<int>(std::clamp(first + count, 0.0, cells));
    const glm::ivec2 grid(lattice_.cells().z, lattice_.cells().y);
    const int taken = std::max(end - first_, 0);
    if (particles.rolledOut()) perLayer_ = std::max(taken, 1);
    layers_.resize(static_cast<size_t>(taken / perLayer_),
                   Layer{SectionSlice(grid), 0, 0, std::vector<int>(static_cast<size_t>(grid.x))});
    living_ = particles.livingIn(first_, end);
    enterOriginal();
    enterPresent();
}

std::optional<size_t> CutLayers::layerOf(const vec4& position) const {
    const double cell =
        std::floor((static_cast<double>(position.x) - static_cast<double>(lattice_.low.x)) / spacing_) - first_;
    if (!(cell >= 0 && cell < static_cast<double>(layers_.size()) * perLayer_)) return std::nullopt;
    const size_t layer = static_cast<size_t>(cell) / static_cast<size_t>(perLayer_);
    return layers_[layer].had > 0 ? std::optional(layer) : std::nullopt;
}

void CutLayers::enterOriginal() {
    std::vector<int> tops(static_cast<size_t>(lattice_.cells().z), kNoRow); // uppermost row of the workpiece
    bottom_ = lattice_.cells().y;
    const auto slots = particles_.originalIn(first_, first_ + static_cast<int>(layers_.size()) * perLayer_);
    for (const size_t slot : slots) {
        const glm::ivec3 cell = lattice_.cellAt(particles_.original()[slot].position);
        ++layers_[layerOf(cell)].had;
        int& top = tops[static_cast<size_t>(cell.z)];
        top = std::max(top, cell.y);
        bottom_ = std::min(bottom_, cell.y);
    }
    level_ = levelOf(tops);
    if (particles_.rolledOut())
        enterMeanPeaks(slots);
    else
        enterPeaks(slots);
}

bool CutLayers::melted(size_t slot) const {
    return !(particles_.phase(slot) & PHASE_LATTICE) && static_cast<double>(particles_.heat(slot).z) >= cut_.fusion;
}

void CutLayers::enterPeaks(const std::vector<size_t>& slots) {
    for (const size_t slot : slots) {
        const glm::ivec3 cell = lattice_.cellAt(particles_.original()[slot].position);
        const auto peak = static_cast<double>(particles_.heat(slot).z);
        layers_[layerOf(cell)].slice.setPeak({cell.z, cell.y}, melted(slot) ? SectionSlice::kGone : peak);
    }
}

/// Gives a cell of several particles their mean, or marks it as gone if most of them are.
void CutLayers::enterMeanPeaks(const std::vector<size_t>& slots) {
    struct Sum {
        double kelvin = 0;
        int stayed = 0, gone = 0;
    };
    std::map<std::pair<int, int>, Sum> cells; // sums by column and row; all slots are in the one layer
    for (const size_t slot : slots) {
        const glm::ivec3 cell = lattice_.cellAt(particles_.original()[slot].position);
        Sum& sum = cells[{cell.z, cell.y}];
        if (melted(slot)) {
            ++sum.gone;
            continue;
        }
        sum.kelvin += static_cast<double>(particles_.heat(slot).z);
        ++sum.stayed;
    }
    for (const auto& [cell, sum] : cells)
        layers_[0].slice.setPeak({cell.first, cell.second},
                                 sum.gone > sum.stayed ? SectionSlice::kGone : sum.kelvin / sum.stayed);
}

void CutLayers::enterPresent() {
    const auto low = static_cast<double>(lattice_.low.z);
    for (const size_t slot : living_) {
        const vec4& at = particles_.position(slot);
        const auto layer = layerOf(at);
        if (!layer) continue;
        ++layers_[*layer].holds;
        std::vector<int>& columns = layers_[*layer].columns;
        const double column = std::floor((static_cast<double>(at.z) - low) / spacing_);
        if (column >= 0 && column < static_cast<double>(columns.size())) ++columns[static_cast<size_t>(column)];
    }
}

int CutLayers::used() const {
    return static_cast<int>(std::count_if(layers_.begin(), layers_.end(), [](const Layer& l) { return l.had > 0; }));
}

template <class Value>
double CutLayers::mean(Value value) const {
    double sum = 0;
    for (const Layer& layer : layers_)
        if (layer.had > 0) sum += value(layer);
    return sum / std::max(used(), 1);
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

double CutLayers::widestHole() const {
    int widest = 0;
    for (const Layer& layer : layers_) {
        if (layer.had == 0) continue;
        const glm::ivec2 ends = heldColumns(layer.slice);
        int run = 0;
        for (int x = ends.x; x <= ends.y; ++x) {
            run = layer.columns[static_cast<size_t>(x)] == 0 ? run + 1 : 0;
            widest = std::max(widest, run);
        }
    }
    return widest >= kLeastHole ? widest * spacing_ : 0;
}

std::optional<double> CutLayers::coolingTime() const {
    double sum = 0;
    size_t molten = 0, cooled = 0;
    for (const size_t slot : living_) {
        if (!layerOf(particles_.position(slot)) || static_cast<double>(particles_.heat(slot).z) < cut_.fusion) continue;
        ++molten;
        if (particles_.position(slot).w > kCooled || !(particles_.heat(slot).w > 0)) continue;
        ++cooled;
        sum += static_cast<double>(particles_.heat(slot).w);
    }
    if (cooled == 0 || static_cast<double>(cooled) < kCooledShare * static_cast<double>(molten)) return std::nullopt;
    return sum / static_cast<double>(cooled);
}

void CutLayers::measureSeamEdges(Section& section) const {
    const int seam = static_cast<int>(std::lround(-static_cast<double>(lattice_.low.z) / spacing_));
    const double whole = *level_ + 1 - bottom_; // cells
    glm::dvec2 sum(0);
    double roots = 0, faces = 0;
    for (const Layer& layer : layers_) {
        if (layer.had == 0) continue;
        const auto unfused = unfusedBeside(layer.slice, seam, cut_.fusion);
        if (!unfused) return;
        sum += *unfused;
        const double more = std::max(unfused->x, unfused->y);
        roots += more <= 0 ? 1 : 0;
        faces += more < whole ? 1 : 0;
    }
    sum *= spacing_ / used();
    section.unfusedEdges = {sum.x, sum.y};
    section.rootFused = roots / used();
    section.facesFused = faces / used();
}

std::optional<FaceStretch> CutLayers::meanFusedTop() const {
    glm::dvec2 sum(0);
    double count = 0;
    for (const Layer& layer : layers_) {
        if (layer.had == 0) continue;
        const auto fused = fusedTop(layer.slice, cut_.fusion);
        if (!fused) continue;
        sum += *fused;
        ++count;
    }
    if (count == 0) return std::nullopt;
    return FaceStretch{columnPlace(sum.x / count), columnPlace(sum.y / count)};
}

void CutLayers::measureLevel(const WeldOutline& outline, Section& section) const {
    const double height = rowHeight(*level_ + 1);
    const PlateFace face{{0, height}};
    section.bead = measureBead(outline, face, spacing_);
    section.fusedTop = meanFusedTop();
    measureSeamEdges(section);
    std::optional<FaceStretch> weld = section.fusion.stretch;
    if (section.bead->toes) weld = {(*section.bead->toes)[0].place, (*section.bead->toes)[1].place};
    if (!weld) return;
    section.undercut = undercutBeside(outline, face, *weld, spacing_);
    section.underfill = grooveDepth(outline, face, *weld, spacing_).value_or(0);
    const PlateFace under{{0, rowHeight(bottom_)}, {-1, 0}, {0, -1}};
    section.rootConcavity = grooveDepth(outline, under, {-weld->high, -weld->low}, spacing_).value_or(0);
}

double CutLayers::uprightHeight(glm::ivec2 corner) const {
    const auto any = std::find_if(layers_.begin(), layers_.end(), [](const Layer& layer) { return layer.had > 0; });
    int rows = 0;
    while (any->slice.held({corner.x - 1, corner.y + rows}))
        ++rows;
    return rows * spacing_;
}

void CutLayers::measureCorner(const WeldOutline& outline, glm::ivec2 corner, Section& section) const {
    const PlateFace base{{columnPlace(corner.x), rowHeight(corner.y)}};
    section.fillet = measureFillet(outline, base, spacing_);
    if (!section.openCorner) {
        const double edge = uprightHeight(corner);
        if (section.fillet && section.fillet->toes[1].place >= edge) section.coveredEdge = edge;
        section.rootFusion = mean([&](const Layer& l) { return rootFusion(l.slice, corner, cut_.fusion) * spacing_; });
        section.rootFused =
            mean([&](const Layer& l) { return rootFusion(l.slice, corner, cut_.fusion) > 0 ? 1.0 : 0.0; });
    }
    std::array<FaceStretch, 2>& faces = section.fusedFaces.emplace();
    for (const Layer& layer : layers_) {
        if (layer.had == 0) continue;
        const std::array<glm::dvec2, 2> fused = fusedFaces(layer.slice, corner, cut_.fusion);
        const bool both = std::min(fused[0].y - fused[0].x, fused[1].y - fused[1].x) > 0;
        section.facesFused += both ? 1.0 / used() : 0.0;
        if (section.openCorner && both && std::max(fused[0].x, fused[1].x) <= 0) section.rootFused += 1.0 / used();
        for (const size_t face : {size_t(0), size_t(1)}) {
            faces[face].low += fused[face].x * spacing_ / used();
            faces[face].high += fused[face].y * spacing_ / used();
        }
    }
    if (section.fillet) section.undercut = undercutBeside(outline, base, *section.fillet, spacing_);
}

void CutLayers::measureShape(const SectionMap& map, Section& section) const {
    const WeldOutline outline = weldOutline(map);
    double top = 0; // height of the deposit over the origin
    if (level_) {
        measureLevel(outline, section);
        if (section.bead->height > 0) top = rowHeight(*level_ + 1) + section.bead->height;
    } else {
        const auto any = std::find_if(layers_.begin(), layers_.end(), [](const Layer& layer) { return layer.had > 0; });
        const auto corner = jointCorner(any->slice);
        if (!corner) return;
        section.openCorner = isOpenCorner(any->slice, *corner);
        measureCorner(outline, *corner, section);
        if (section.fillet) top = rowHeight(corner->y) + section.fillet->toes[1].place;
    }
    section.root = measureBead(outline, {{0, rowHeight(bottom_)}, {-1, 0}, {0, -1}}, spacing_);
    section.hole = widestHole();
    section.fusion.box.height = std::max(section.fusion.box.height, top);
    if (section.heatAffected) section.heatAffected->box.height = std::max(section.heatAffected->box.height, top);
}

Section CutLayers::measure(const SectionMap& map) const {
    Section section;
    section.layers = latticeLayers();
    if (section.layers == 0) {
        if (cut_.heatAffected) section.heatAffected.emplace();
        return section;
    }
    for (const Layer& layer : layers_)
        if (layer.had > 0)
            section.deposited +=
                (static_cast<double>(layer.holds) - static_cast<double>(layer.had)) * spacing_ * spacing_;
    section.deposited /= section.layers;
    section.fusion = zoneOf(cut_.fusion);
    section.fusion.box.area = section.fusion.area + section.deposited;
    if (cut_.heatAffected) {
        section.heatAffected = zoneOf(*cut_.heatAffected);
        section.heatAffected->box.area = section.heatAffected->area + section.deposited;
        section.coolingTime = coolingTime();
    }
    measureShape(map, section);
    return section;
}

SectionMap CutLayers::draw() const {
    std::vector<MapParticle> near;
    for (const size_t slot : living_) {
        const vec4& at = particles_.position(slot);
        if (!layerOf(at) || !std::isfinite(at.y) || !std::isfinite(at.z)) continue;
        near.push_back({{at.z, at.y},
                        std::max(particles_.heat(slot).z, at.w),
                        at.w,
                        (particles_.phase(slot) & PHASE_LATTICE) != 0});
    }
    const glm::vec2 size = glm::vec2(lattice_.cells().z, lattice_.cells().y) * lattice_.spacing;
    return makeSectionMap({lattice_.low.z, lattice_.low.y}, size, lattice_.spacing, latticeLayers(), near);
}

} // namespace meltpool
