#include "core/metal/heat/heat_tiles.hpp"

#include "core/metal/heat/heat_barriers.hpp"
#include "shaders/shared/dispatch.h"

#include <algorithm>
#include <span>
#include <vector>

namespace meltpool {

namespace {

constexpr uvec4 kNoGroups(0, 1, 1, 0);
constexpr HeatControl kNothingListed{{1, 1, 1, 0}, kNoGroups,        kNoGroups, kNoGroups,        kNoGroups,
                                     kNoGroups,    uvec3(kNoGroups), 0,         uvec3(kNoGroups), 0};
constexpr size_t kTileLists = 3; ///< lists of tiles in HEAT_LISTS, before the list of slots

} // namespace

HeatTiles::HeatTiles(gl::ShaderLibrary& shaders, const gl::Defines& defines, size_t tiles, size_t slots)
    : count_(tiles),
      listOffLattice_(shaders.compute("metal/heat/list_off_lattice.comp")),
      listTiles_(shaders.compute("metal/heat/list_tiles.comp", defines)),
      listRows_(shaders.compute("metal/heat/list_rows.comp")),
      tiles_(gl::Buffer::gpuOnly("heat tiles", tiles * sizeof(HeatTile))),
      stamps_(gl::Buffer::gpuOnly("heat tile stamps", tiles * sizeof(int))),
      lists_(gl::Buffer::gpuOnly("heat lists", (kTileLists * tiles + slots) * sizeof(uint))),
      listedRows_(gl::Buffer::gpuOnly("heat listed rows", TILE_ROWS * tiles * sizeof(uint))),
      control_("heat control", sizeof(HeatControl)),
      knownCells_(gl::Buffer::gpuOnly("heat known cells", slots * sizeof(uint))),
      tileTexels_("heat texels", tiles_, GL_RGBA32I, sizeof(ivec4)),
      stampTexels_("heat texels", stamps_, GL_R32I, sizeof(int)),
      listTexels_("heat texels", lists_, GL_R32UI, sizeof(uint)),
      listedRowTexels_("heat texels", listedRows_, GL_R32UI, sizeof(uint)) {}

void HeatTiles::setSlots(size_t slots) {
    lists_.resize((kTileLists * count_ + slots) * sizeof(uint));
    listTexels_ = gl::BufferView("heat texels", lists_, GL_R32UI, sizeof(uint));
    knownCells_.resize(slots * sizeof(uint));
}

void HeatTiles::clear() {
    for (const gl::Buffer* buffer : {&tiles_, &stamps_, &lists_, &knownCells_})
        buffer->clear();
}

void HeatTiles::forget() {
    control_.writeValue(kNothingListed);
    knownCells_.clear();
}

void HeatTiles::bind() const {
    stampTexels_.bind(HEAT_TEXELS_STAMPS);
    tileTexels_.bind(HEAT_TEXELS_TILES);
    listTexels_.bind(HEAT_TEXELS_LISTS);
    listedRowTexels_.bind(HEAT_TEXELS_LISTED_ROWS);
    tiles_.bindStorage(HEAT_TILES);
    stamps_.bindStorage(HEAT_TILE_STAMPS);
    lists_.bindStorage(HEAT_LISTS);
    control_.bindStorage(HEAT_CONTROL);
    bindKnownCells();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, control_.name());
}

void HeatTiles::bindKnownCells() const {
    knownCells_.bindStorage(HEAT_KNOWN_CELLS);
}

void HeatTiles::listOffLattice(size_t first, size_t last) const {
    if (first >= last) return;
    listOffLattice_.set("first", static_cast<unsigned>(first));
    listOffLattice_.set("last", static_cast<unsigned>(last));
    listOffLattice_.dispatch(last - first, GROUP_SIZE); // phases -> list of slots off the lattice
    indirectBarrier();
}

void HeatTiles::listTiles() {
    // The lists of slots off the lattice and of tiles that ever held metal stay.
    control_.write(std::as_bytes(std::span(&kNothingListed, 1)).first(offsetof(HeatControl, offLatticeGroups)));
    listedRows_.bindStorage(HEAT_LISTED_ROWS);
    // Tiles -> lists of tiles, of plain tiles' rows.
    listTiles_.dispatchIndirect(offsetof(HeatControl, metalTileGroups));
    indirectBarrier();
}

void HeatTiles::listMixedRows() const {
    listRows_.dispatchIndirect(offsetof(HeatControl, mixedTiles)); // cell theta -> list of rows with metal
    indirectBarrier();
}

OffLatticeList HeatTiles::offLattice() const {
    return {lists_, kTileLists * count_, control_, offsetof(HeatControl, offLatticeCount),
            offsetof(HeatControl, offLatticeGroups)};
}

unsigned HeatTiles::readActive(int stepNumber) const {
    const std::vector<int> stamps = stamps_.read<int>(count_);
    return static_cast<unsigned>(
        std::count_if(stamps.begin(), stamps.end(), [&](int stamp) { return stamp >> TILE_STEP_SHIFT == stepNumber; }));
}

void HeatTiles::transfer(gl::StateArchive& archive) {
    for (const gl::Buffer* buffer : {&tiles_, &stamps_, &lists_, &control_, &knownCells_})
        archive.list(*buffer, buffer->bytes());
}

size_t HeatTiles::bytes() const {
    size_t sum = 0;
    for (const gl::Buffer* buffer : {&tiles_, &stamps_, &lists_, &listedRows_, &control_, &knownCells_})
        sum += buffer->bytes();
    return sum;
}

} // namespace meltpool
