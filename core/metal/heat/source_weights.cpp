#include "core/metal/heat/source_weights.hpp"

#include "core/base/error.hpp"
#include "core/metal/heat/heat_barriers.hpp"

#include <glm/common.hpp>

#include <string>

namespace meltpool {

namespace {

HeatSourceData dataOf(const HeatSource& source, const MetalLattice& lattice) {
    HeatSourceData data{};
    data.position = source.position;
    data.kind = source.kind;
    data.axis = source.axis;
    data.power = source.power;
    data.travel = source.travel;
    data.size = source.size;
    data.halfWidth = source.halfWidth;
    data.depth = source.depth;
    data.rear = source.rear;
    data.frontFraction = source.frontFraction;
    data.tipTemperature = source.tipTemperature;
    data.tipConductance = source.tipConductance;
    data.before = source.before;
    data.beyond = source.beyond;
    data.fullWeight = source.fullWeight;
    const glm::ivec3 lastTile = lattice.tiles - 1;
    const glm::ivec3 cellLimit = lattice.cells();
    // Clamped before the division, which rounds towards zero, and against sources with a reach beyond all numbers.
    const auto tileAt = [&](glm::vec3 place) {
        const glm::vec3 cell = glm::clamp((place - lattice.low) / lattice.spacing, glm::vec3(-1), glm::vec3(cellLimit));
        return glm::ivec3(glm::floor(cell / static_cast<float>(TILE_EDGE)));
    };
    const glm::ivec3 low = glm::clamp(tileAt(source.position - source.reach()), glm::ivec3(0), lastTile);
    const glm::ivec3 high = glm::clamp(tileAt(source.position + source.reach()), glm::ivec3(0), lastTile);
    data.firstTile = low;
    data.tileExtent = high - low + 1;
    data.tileCount = data.tileExtent.x * data.tileExtent.y * data.tileExtent.z;
    return data;
}

} // namespace

SourceWeights::SourceWeights(gl::ShaderLibrary& shaders)
    : sum_(shaders.compute("metal/heat/sum_source_weights.comp")),
      sums_(gl::Buffer::gpuOnly("heat source sums", HEAT_SOURCES * sizeof(float))) {}

void SourceWeights::write(std::span<const HeatSource> sources, const MetalLattice& lattice, HeatBlock& block) {
    if (sources.size() > HEAT_SOURCES)
        throw RuntimeFault("at most " + std::to_string(HEAT_SOURCES) + " heat sources can burn at once");
    count_ = static_cast<unsigned>(sources.size());
    block.sourceCount = static_cast<int>(sources.size());
    for (size_t i = 0; i < sources.size(); ++i)
        block.sources[i] = dataOf(sources[i], lattice);
}

void SourceWeights::sum() const {
    sums_.bindStorage(HEAT_SOURCE_SUMS);
    if (count_ == 0) return;
    sum_.dispatchGroups(count_); // cell theta, weight -> sum of weights a source
    storageBarrier();
}

} // namespace meltpool
