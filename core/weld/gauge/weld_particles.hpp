// The metal of a weld, read back once for any number of cuts.
#pragma once

#include "core/metal/state/metal_state.hpp"

#include <optional>
#include <span>
#include <vector>

namespace meltpool {

/// Values of particles that cuts need, slot by slot; see shaders/shared/metal.h.
struct ParticleValues {
    std::vector<vec4> positions; ///< xyz m, w K
    std::vector<vec4> heats;
    std::vector<uint> phases;
};

class WeldParticles {
  public:
    /// Takes particles that were read before, whose lattice this is. All else as below.
    WeldParticles(const MetalLattice& lattice, ParticleValues values, std::span<const MetalSeed> original,
                  std::optional<double> pipeRadius = {});

    /// Reads every particle and waits for the GPU. `original`: the workpiece before welding, as measureSection() asks
    /// for it; it must outlive this. Throws RuntimeFault when the state holds fewer particles than `original`.
    WeldParticles(const MetalState& state, std::span<const MetalSeed> original);

    /// Reads a pipe of this outer radius (m), whose axis is z under the origin, rolled out like a plate: places are x:
    /// length on the outer face from its top towards +x, y: height over that face, z. The lattice is one of the
    /// rolled-out pipe, in which a cell holds one particle on average, but none or several in places.
    WeldParticles(const MetalState& state, std::span<const MetalSeed> original, double pipeRadius);

    bool rolledOut() const { return rolledOut_; }
    const MetalLattice& lattice() const { return lattice_; }
    std::span<const MetalSeed> original() const { return rolledOut_ ? rolledSeeds_ : original_; }
    const vec4& position(size_t slot) const { return values_.positions[slot]; } ///< xyz m, w K
    const vec4& heat(size_t slot) const { return values_.heats[slot]; }         ///< see shaders/shared/metal.h
    uint phase(size_t slot) const { return values_.phases[slot]; }

    /// Returns the living particles in the lattice layers `first` up to but not `end` along the seam; slots ascend.
    std::vector<size_t> livingIn(int first, int end) const { return gather(living_, first, end); }
    /// Returns the workpiece's seeds in these lattice layers, by their places before welding; slots ascend.
    std::vector<size_t> originalIn(int first, int end) const { return gather(originals_, first, end); }

  private:
    using Layers = std::vector<std::vector<size_t>>; ///< slots by lattice layer along the seam

    static std::vector<size_t> gather(const Layers& layers, int first, int end);

    void sort();

    MetalLattice lattice_;
    std::span<const MetalSeed> original_;
    bool rolledOut_ = false;
    std::vector<MetalSeed> rolledSeeds_; ///< seeds of a rolled-out pipe
    ParticleValues values_;
    Layers living_, originals_;
};

} // namespace meltpool
