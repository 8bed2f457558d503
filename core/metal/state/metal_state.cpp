#include "core/metal/state/metal_state.hpp"

#include "core/base/error.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meltpool {

namespace {

/// Share of liquid above which solid metal begins to flow, and below which liquid metal freezes.
constexpr float kMeltFraction = 0.6F;
constexpr float kFreezeFraction = 0.3F;

} // namespace

MetalLattice MetalLattice::covering(glm::vec3 low, glm::vec3 high, float spacing) {
    MetalLattice lattice;
    lattice.low = low;
    lattice.spacing = spacing;
    // Subtracts a little, so that rounding of the corners adds no cell to a box of whole cells.
    const glm::vec3 cells = glm::ceil((high - low) / spacing - 1e-3F);
    lattice.tiles = glm::max(glm::ivec3(1), (glm::ivec3(cells) + (TILE_EDGE - 1)) / TILE_EDGE);
    return lattice;
}

size_t MetalLattice::tileCount() const {
    return static_cast<size_t>(tiles.x) * static_cast<size_t>(tiles.y) * static_cast<size_t>(tiles.z);
}

glm::ivec3 MetalLattice::cellAt(glm::vec3 place) const {
    return glm::ivec3(glm::floor((place - low) / spacing));
}

bool MetalLattice::contains(glm::ivec3 cell) const {
    return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, cells()));
}

size_t MetalLattice::index(glm::ivec3 cell) const {
    const glm::ivec3 tile = cell / TILE_EDGE;
    const glm::ivec3 inside = cell - tile * TILE_EDGE;
    const auto tileIndex = static_cast<size_t>((tile.z * tiles.y + tile.y) * tiles.x + tile.x);
    return tileIndex * TILE_CELLS + static_cast<size_t>((inside.z * TILE_EDGE + inside.y) * TILE_EDGE + inside.x);
}

std::vector<MetalSeed> latticeSeeds(const MetalLattice& lattice, glm::vec3 low, glm::vec3 high, float temperature,
                                    unsigned extraPhase) {
    std::vector<MetalSeed> seeds;
    const glm::ivec3 tiles = lattice.tiles;
    for (int tile = 0; tile < static_cast<int>(lattice.tileCount()); ++tile)
        for (int inside = 0; inside < TILE_CELLS; ++inside) {
            const glm::ivec3 corner = glm::ivec3(tile % tiles.x, tile / tiles.x % tiles.y, tile / (tiles.x * tiles.y));
            const glm::ivec3 cell = corner * TILE_EDGE + glm::ivec3(inside % TILE_EDGE, inside / TILE_EDGE % TILE_EDGE,
                                                                    inside / (TILE_EDGE * TILE_EDGE));
            const glm::vec3 centre = lattice.centre(cell);
            if (glm::all(glm::greaterThanEqual(centre, low)) && glm::all(glm::lessThan(centre, high)))
                seeds.push_back({centre, temperature, PHASE_ALIVE | PHASE_LATTICE | extraPhase, glm::vec3(0)});
        }
    return seeds;
}

LatticeBox latticeBox(const MetalLattice& lattice, glm::vec3 low, glm::vec3 high) {
    LatticeBox box{high, low};
    for (int axis = 0; axis < 3; ++axis) {
        const auto planeNear = [&](int cell, float wanted) {
            const float plane = lattice.low[axis] + static_cast<float>(cell) * lattice.spacing;
            return std::abs(plane - wanted) < 1e-3F * lattice.spacing ? wanted : plane;
        };
        for (int cell = 0; cell < lattice.cells()[axis]; ++cell) {
            const float centre = lattice.centre(glm::ivec3(cell))[axis];
            if (!(centre >= low[axis] && centre < high[axis])) continue;
            box.low[axis] = std::min(box.low[axis], planeNear(cell, low[axis]));
            box.high[axis] = planeNear(cell + 1, high[axis]);
        }
        if (box.low[axis] >= box.high[axis]) box.high[axis] = box.low[axis];
    }
    return box;
}

MetalState::MetalState(const MetalLattice& lattice, const HeatTable& table, double density, size_t capacity)
    : position("metal position", capacity * sizeof(vec4)),
      velocity("metal velocity", capacity * sizeof(vec4)),
      heat("metal heat", capacity * sizeof(vec4)),
      phase("metal phase", capacity * sizeof(uint)),
      latticeSlots("metal lattice", lattice.cellCount() * sizeof(uint)),
      counters("metal counters", sizeof(MetalCounters)),
      frozenAt("metal freezing times", capacity * sizeof(float)),
      changes("metal changes", (1 + capacity) * sizeof(uint)),
      lattice_(lattice),
      table_(table),
      capacity_(capacity),
      density_(density),
      mass_(density * static_cast<double>(lattice.spacing) * static_cast<double>(lattice.spacing) *
            static_cast<double>(lattice.spacing)),
      blockBuffer_("metal block", sizeof(MetalBlock)) {
    block_.origin = lattice.low;
    block_.spacing = lattice.spacing;
    block_.tiles = lattice.tiles;
    block_.capacity = static_cast<int>(capacity);
    block_.gravity = {0, -9.81F, 0};
    block_.particleMass = static_cast<float>(mass_);
    block_.solidusEnthalpy = static_cast<float>(table.solidusEnthalpy());
    block_.liquidusEnthalpy = static_cast<float>(table.liquidusEnthalpy());
    block_.meltsAbove = kMeltFraction;
    block_.freezesBelow = kFreezeFraction;
    writeBlock();
}

void MetalState::reset() {
    for (const gl::Buffer* buffer :
         {&position, &velocity, &heat, &phase, &latticeSlots, &counters, &frozenAt, &changes})
        buffer->clear();
    particles_ = 0;
    regroupings_ = labellings_ = 0;
    latticeMetal_ = {};
    onLattice_ = false;
}

void MetalState::setCapacity(size_t capacity) {
    for (gl::Buffer* buffer : {&position, &velocity, &heat})
        buffer->resize(capacity * sizeof(vec4));
    for (gl::Buffer* buffer : {&phase, &frozenAt})
        buffer->resize(capacity * sizeof(uint));
    changes.resize((1 + capacity) * sizeof(uint));
    capacity_ = capacity;
    block_.capacity = static_cast<int>(capacity);
    writeBlock();
}

void MetalState::writeBlock() {
    blockBuffer_.writeValue(block_);
}

void MetalState::setGravity(glm::vec3 gravity) {
    block_.gravity = gravity;
    writeBlock();
}

void MetalState::noteOnLattice(glm::ivec3 cell) {
    if (!std::exchange(onLattice_, true)) latticeMetal_ = {cell, cell};
    latticeMetal_ = {glm::min(latticeMetal_.low, cell), glm::max(latticeMetal_.high, cell)};
}

void MetalState::add(std::span<const MetalSeed> seeds) {
    if (particles_ + seeds.size() > capacity_)
        throw RuntimeFault("no room for " + std::to_string(seeds.size()) + " more particles next to " +
                           std::to_string(particles_) + " of " + std::to_string(capacity_));
    auto& [positions, velocities, heats, notFrozen, phases, cells] = staging_;
    for (auto* values : {&positions, &velocities, &heats})
        values->clear();
    notFrozen.clear();
    phases.clear();
    cells.clear();
    for (const MetalSeed& seed : seeds) {
        const double enthalpy = table_.enthalpyAt(static_cast<double>(seed.temperature));
        const auto rounded = static_cast<float>(enthalpy);
        const auto residual = static_cast<float>(enthalpy - static_cast<double>(rounded));
        positions.emplace_back(seed.position, seed.temperature);
        velocities.emplace_back(seed.velocity, 0.0F);
        heats.emplace_back(rounded, residual, seed.temperature, 0.0F);
        notFrozen.push_back((seed.phase & PHASE_LIQUID) != 0 ? METAL_MOLTEN : 0.0F);
        phases.push_back(seed.phase);
        if (!(seed.phase & PHASE_LATTICE)) continue;
        const glm::ivec3 cell = lattice_.cellAt(seed.position);
        if (!lattice_.contains(cell)) throw RuntimeFault("a lattice particle is outside the lattice");
        noteOnLattice(cell);
        const uint slot = static_cast<uint>(particles_ + phases.size());
        cells.emplace_back(lattice_.index(cell), slot);
    }
    if (!cells.empty()) {
        auto all = latticeSlots.read<uint>(lattice_.cellCount());
        for (const auto& [cell, slot] : cells)
            all[cell] = slot;
        latticeSlots.write(std::span<const uint>(all));
    }
    position.write(std::span<const vec4>(positions), particles_ * sizeof(vec4));
    velocity.write(std::span<const vec4>(velocities), particles_ * sizeof(vec4));
    heat.write(std::span<const vec4>(heats), particles_ * sizeof(vec4));
    frozenAt.write(std::span<const float>(notFrozen), particles_ * sizeof(float));
    phase.write(std::span<const uint>(phases), particles_ * sizeof(uint));
    particles_ += seeds.size();
    counters.writeValue(static_cast<uint>(particles_), offsetof(MetalCounters, particles));
}

void MetalState::transfer(gl::StateArchive& archive) {
    archive.count(particles_, capacity_);
    archive.values(regroupings_, labellings_, onLattice_, latticeMetal_.low, latticeMetal_.high);
    for (const gl::Buffer* each : {&position, &velocity, &heat})
        archive.rows(*each, particles_, sizeof(vec4));
    archive.rows(frozenAt, particles_, sizeof(float));
    archive.buffer(phase, particles_ * sizeof(uint));
    archive.list(latticeSlots, latticeSlots.bytes());
    archive.buffer(counters, sizeof(MetalCounters));
    archive.list(changes, (1 + particles_) * sizeof(uint));
}

void MetalState::bind() const {
    position.bindStorage(METAL_POSITION);
    velocity.bindStorage(METAL_VELOCITY);
    heat.bindStorage(METAL_HEAT);
    phase.bindStorage(METAL_PHASE);
    latticeSlots.bindStorage(METAL_LATTICE);
    counters.bindStorage(METAL_COUNTERS);
    blockBuffer_.bindUniform(METAL_BLOCK);
}

size_t MetalState::bytes() const {
    return position.bytes() + velocity.bytes() + heat.bytes() + phase.bytes() + latticeSlots.bytes() +
           counters.bytes() + frozenAt.bytes() + changes.bytes();
}

double MetalState::readEnergy() const {
    const auto heats = heat.read<vec4>(particles_);
    const auto phases = phase.read<uint>(particles_);
    double sum = 0;
    for (size_t i = 0; i < particles_; ++i)
        if (phases[i] & PHASE_ALIVE) sum += static_cast<double>(heats[i].x) + static_cast<double>(heats[i].y);
    return sum * mass_;
}

} // namespace meltpool
