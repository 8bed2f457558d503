#include "core/metal/heat/conduction.hpp"

#include "core/metal/heat/heat_barriers.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace meltpool {

namespace {

gl::Defines withSources(gl::Defines defines) {
    defines["SOURCES"] = "1";
    return defines;
}

} // namespace

Conduction::Conduction(gl::ShaderLibrary& shaders, const gl::Defines& defines, size_t cells, size_t slots, bool ledger)
    : cells_(cells),
      hasLedger_(ledger),
      deposit_(shaders.compute("metal/heat/deposit.comp")),
      averageCells_(shaders.compute("metal/heat/average_cells.comp")),
      conductUnreached_(shaders.compute("metal/heat/conduct_off_lattice.comp", defines)),
      conductReached_(shaders.compute("metal/heat/conduct_off_lattice.comp", withSources(defines))),
      advanceOffLattice_(shaders.compute("metal/heat/advance_off_lattice.comp", defines)),
      conductLattice_(shaders.compute("metal/heat/conduct_lattice.comp", defines)),
      advanceMixed_(shaders.compute("metal/heat/advance_mixed.comp", defines)),
      table_("heat table", HEAT_TABLE_ENTRIES * sizeof(vec4)),
      cellTheta_(gl::Buffer::gpuOnly("heat cell theta", 2 * cells * sizeof(float))),
      cellWeight_(gl::Buffer::gpuOnly("heat cell weight", cells * sizeof(uint))),
      cellSums_(gl::Buffer::gpuOnly("heat cell sums", cells * sizeof(uint))),
      cellRanges_(gl::Buffer::gpuOnly("heat cell ranges", cells * sizeof(uvec2))),
      ledger_(gl::Buffer::gpuOnly("heat ledger", ledger ? (cells + slots) * sizeof(vec4) : 4)),
      tableTexels_("heat texels", table_, GL_RGBA32F, sizeof(vec4)),
      thetaTexels_("heat texels", cellTheta_, GL_R32F, sizeof(float)),
      weightTexels_("heat texels", cellWeight_, GL_R32UI, sizeof(uint)),
      thetaRowTexels_("heat texels", cellTheta_, GL_RGBA32F, sizeof(vec4)) {}

void Conduction::setTable(const HeatTable& table, HeatBlock& block) {
    std::vector<vec4> samples;
    for (int piece = 0; piece < 3; ++piece) {
        const HeatTable::Piece& from = table.pieces()[static_cast<size_t>(piece)];
        block.tableStart[piece] = from.start;
        block.tableScale[piece] = from.inverseStep;
        for (size_t i = 0; i < HEAT_TABLE_ROW; ++i) {
            const auto& own = from.samples[i];
            const auto& next = from.samples[std::min<size_t>(i + 1, HEAT_TABLE_STEPS)];
            samples.emplace_back(own[0], own[1], next[0], next[1]);
        }
    }
    table_.write(std::span<const vec4>(samples));
}

void Conduction::setSlots(size_t slots) {
    if (hasLedger_) ledger_.resize((cells_ + slots) * sizeof(vec4));
}

void Conduction::clear() {
    for (const gl::Buffer* buffer : {&cellTheta_, &cellWeight_, &cellSums_, &cellRanges_, &ledger_})
        buffer->clear();
}

void Conduction::bind() const {
    tableTexels_.bind(HEAT_TEXELS_TABLE);
    thetaTexels_.bind(HEAT_TEXELS_THETA);
    weightTexels_.bind(HEAT_TEXELS_WEIGHT);
    thetaRowTexels_.bind(HEAT_TEXELS_THETA_ROWS);
    cellTheta_.bindStorage(HEAT_CELL_THETA);
    cellWeight_.bindStorage(HEAT_CELL_WEIGHT);
    cellSums_.bindStorage(HEAT_CELL_SUMS);
    cellRanges_.bindStorage(HEAT_CELL_RANGE);
    ledger_.bindStorage(HEAT_LEDGER);
}

void Conduction::depositOffLattice() const {
    // Enthalpies, positions -> cell sums, weights, tiles with metal off the lattice.
    deposit_.dispatchIndirect(offsetof(HeatControl, offLatticeGroups));
    indirectBarrier();
}

void Conduction::averageCells() const {
    averageCells_.dispatchIndirect(offsetof(HeatControl, offLatticeTiles)); // cell sums, weights -> cell theta
    storageBarrier();
}

void Conduction::conductMixedTiles() const {
    // Cell theta, weight, sums of sources -> cell power, area.
    conductReached_.dispatchIndirect(offsetof(HeatControl, reachedRows));
    conductUnreached_.dispatchIndirect(offsetof(HeatControl, unreachedRows));
    storageBarrier();
}

void Conduction::advanceOffLattice() const {
    // Cell power, area, theta -> enthalpy of metal off the lattice.
    advanceOffLattice_.dispatchIndirect(offsetof(HeatControl, offLatticeGroups));
    storageBarrier();
}

/// The plain tiles come first: they read values that the mixed ones change.
void Conduction::advanceLattice() const {
    // Cell theta -> enthalpy, theta in the other half.
    conductLattice_.dispatchIndirect(offsetof(HeatControl, plainRows));
    storageBarrier();
    // Cell power, area -> enthalpy of the lattice, cell theta; cell sums cleared.
    advanceMixed_.dispatchIndirect(offsetof(HeatControl, mixedRows));
    indirectBarrier();
}

HeatBalance Conduction::readBalance() const {
    HeatBalance balance;
    if (!hasLedger_) return balance;
    for (const vec4& entry : ledger_.read<vec4>(ledger_.bytes() / sizeof(vec4))) {
        balance.gained += static_cast<double>(entry.x) + static_cast<double>(entry.y);
        balance.lost += static_cast<double>(entry.z) + static_cast<double>(entry.w);
    }
    return balance;
}

/// Saves also the sums and ranges of cells, which are zero between steps: zeros cost nothing, and this part need not
/// know which pass clears them.
void Conduction::transfer(gl::StateArchive& archive) {
    for (const gl::Buffer* buffer : {&cellTheta_, &cellSums_, &ledger_})
        archive.buffer(*buffer, buffer->bytes());
    for (const gl::Buffer* buffer : {&cellWeight_, &cellRanges_})
        archive.list(*buffer, buffer->bytes());
}

size_t Conduction::bytes() const {
    size_t sum = 0;
    for (const gl::Buffer* buffer : {&table_, &cellTheta_, &cellWeight_, &cellSums_, &cellRanges_, &ledger_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
