// The particles of the physical metal: their buffers on the GPU, the lattice they start on, and how both are filled.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/state_archive.hpp"
#include "core/metal/material/heat_table.hpp"
#include "shaders/shared/metal.h"

#include <glm/vec3.hpp>

#include <vector>

namespace meltpool {

/// The cubic lattice that solid metal starts on; cells are stored tile by tile.
struct MetalLattice {
    glm::vec3 low{0};    ///< low corner of cell (0, 0, 0), m
    float spacing = 0;   ///< edge of a cell, m
    glm::ivec3 tiles{0}; ///< size in tiles of TILE_EDGE cells

    /// The smallest lattice that covers the box from `low` to `high`, its cells' corners on `low`.
    static MetalLattice covering(glm::vec3 low, glm::vec3 high, float spacing);

    glm::ivec3 cells() const { return tiles * TILE_EDGE; }
    size_t tileCount() const;
    size_t cellCount() const { return tileCount() * TILE_CELLS; }
    glm::vec3 centre(glm::ivec3 cell) const { return low + (glm::vec3(cell) + 0.5F) * spacing; }
    glm::ivec3 cellAt(glm::vec3 place) const;
    bool contains(glm::ivec3 cell) const;
    /// Index of a cell in the lattice buffer; the cell must be inside.
    size_t index(glm::ivec3 cell) const;
};

/// The start of one particle.
struct MetalSeed {
    glm::vec3 position{0};        ///< m
    float temperature = 293.15F;  ///< K
    unsigned phase = PHASE_ALIVE; ///< PHASE_... bits; with PHASE_LATTICE the position is its cell's centre
    glm::vec3 velocity{0};        ///< m/s
};

/// A box of lattice cells, its ends included.
struct CellBox {
    glm::ivec3 low{0}, high{0};
};

/// Seeds for every cell of `lattice` whose centre is from `low` up to, but not at, `high`, solid and on the lattice,
/// tile by tile so that neighbours in space are neighbours in memory. Boxes that share a face share no cell.
std::vector<MetalSeed> latticeSeeds(const MetalLattice& lattice, glm::vec3 low, glm::vec3 high, float temperature,
                                    unsigned extraPhase = 0);

/// The box of the cells for which latticeSeeds() makes a seed, m. Along an axis without seeds it ends where it begins.
/// Corners within a thousandth of a spacing of the lattice keep their value.
struct LatticeBox {
    glm::vec3 low{0}, high{0};
};
LatticeBox latticeBox(const MetalLattice& lattice, glm::vec3 low, glm::vec3 high);

/// The buffers that heat and flow work on; see shaders/shared/metal.h for their content.
class MetalState {
  public:
    /// `density`: that of the particle masses (kg/m³). `capacity`: of seeds and later filler, in particles.
    MetalState(const MetalLattice& lattice, const HeatTable& table, double density, size_t capacity);

    /// Removes all particles without allocating.
    void reset();
    /// Sets another table with equal enthalpies and temperatures: only its conductivity differs.
    void setTable(const HeatTable& table) { table_ = table; }

    /// Sets the capacity in particles, no fewer than there are or than the next restored state has. The caller must
    /// bind the buffers again and remake its texel views. Waits for nothing. If the driver has no memory, throws
    /// RuntimeFault and leaves the capacity unchanged.
    void setCapacity(size_t capacity);

    /// Puts particles into the next free slots. Throws RuntimeFault if the capacity is too small.
    void add(std::span<const MetalSeed> seeds);

    /// Saves or restores all that the next step reads. The table is the owner's.
    void transfer(gl::StateArchive& archive);

    /// Binds the particle buffers and the block to their fixed places.
    void bind() const;

    const MetalLattice& lattice() const { return lattice_; }
    /// The cells outside which no metal was ever on the lattice; one cell if none was.
    const CellBox& latticeMetal() const { return latticeMetal_; }
    const HeatTable& table() const { return table_; }
    size_t particles() const { return particles_; }
    size_t capacity() const { return capacity_; }
    double particleMass() const { return mass_; } ///< kg
    double density() const { return density_; }   ///< kg/m³
    void setGravity(glm::vec3 gravity);           ///< m/s²

    /// GPU memory in bytes.
    size_t bytes() const;

    /// Sum of m H over the living particles with their residuals, J. Waits for the GPU.
    double readEnergy() const;

    /// Increments when phase bits may have changed that `changes` does not list: the CPU wrote phases and called
    /// noteRegrouping().
    unsigned regroupings() const { return regroupings_; }
    void noteRegrouping() { ++regroupings_; }
    /// Increments when fragments were labelled: those that came free have left the lattice.
    unsigned labellings() const { return labellings_; }
    void noteLabelling() { ++labellings_; }

    gl::Buffer position, velocity, heat, phase, latticeSlots, counters;
    gl::Buffer frozenAt; ///< time of freezing, likewise
    gl::Buffer changes;  ///< see shaders/shared/metal.h; each user binds it

  private:
    void writeBlock();

    void noteOnLattice(glm::ivec3 cell);

    MetalLattice lattice_;
    CellBox latticeMetal_;
    bool onLattice_ = false; ///< true if some metal was
    HeatTable table_;
    size_t capacity_;
    size_t particles_ = 0;
    /// Buffers of add(), reused so that filler costs no allocation.
    struct {
        std::vector<vec4> positions, velocities, heats;
        std::vector<float> frozenAt;
        std::vector<uint> phases;
        std::vector<std::pair<size_t, uint>> cells;
    } staging_;
    unsigned regroupings_ = 0;
    unsigned labellings_ = 0;
    double density_;
    double mass_;
    MetalBlock block_{};
    gl::Buffer blockBuffer_;
};

} // namespace meltpool
