#include "core/weld/gauge/weld_section.hpp"

#include "core/weld/gauge/cut_layers.hpp"

#include <algorithm>
#include <limits>

namespace meltpool {

namespace {

WeldSection cutParticles(const WeldParticles& particles, const SectionCut& cut) {
    const CutLayers layers(particles, cut);
    WeldSection section{cut, {}, layers.draw()};
    section.figures = layers.measure(section.map);
    return section;
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
    return cutParticles(WeldParticles(state, original), cut);
}

Section measureSection(const MetalState& state, std::span<const MetalSeed> original, const SectionCut& cut) {
    return cutWeld(state, original, cut).figures;
}

Section measureSection(const WeldParticles& particles, const SectionCut& cut) {
    return cutParticles(particles, cut).figures;
}

std::vector<Section> measureSections(const MetalState& state, std::span<const MetalSeed> original,
                                     std::span<const SectionCut> cuts) {
    const WeldParticles particles(state, original);
    std::vector<Section> sections;
    for (const SectionCut& cut : cuts)
        sections.push_back(measureSection(particles, cut));
    return sections;
}

std::optional<FaceStretch> weldedStretch(const WeldParticles& particles, double fusion) {
    constexpr float kFar = std::numeric_limits<float>::max();
    float low = kFar, high = -kFar;
    for (size_t i = 0; i < particles.original().size(); ++i) {
        if (static_cast<double>(particles.heat(i).z) < fusion) continue;
        low = std::min(low, particles.original()[i].position.x);
        high = std::max(high, particles.original()[i].position.x);
    }
    if (low > high) return std::nullopt;
    return FaceStretch{static_cast<double>(low), static_cast<double>(high)};
}

double middleOfWeld(const MetalState& state, std::span<const MetalSeed> original, double fusion) {
    if (const auto welded = weldedStretch(WeldParticles(state, original), fusion))
        return 0.5 * static_cast<double>(static_cast<float>(welded->low) + static_cast<float>(welded->high));
    constexpr float kFar = std::numeric_limits<float>::max();
    float low = kFar, high = -kFar;
    for (const MetalSeed& seed : original) {
        low = std::min(low, seed.position.x);
        high = std::max(high, seed.position.x);
    }
    return low <= high ? 0.5 * static_cast<double>(low + high) : 0;
}

} // namespace meltpool
