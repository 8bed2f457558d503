// Weights that divide the power of heat sources among the metal in their reach.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/program.hpp"
#include "core/metal/heat/heat_source.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/heat.h"

#include <span>

namespace meltpool {

/// Each cell gets the source's power times its weight over the sum of weights, so that exactly the power goes in.
class SourceWeights {
  public:
    explicit SourceWeights(gl::ShaderLibrary& shaders);

    /// Writes the sources, and the tiles of the lattice in the reach of each, into the block of a step. Throws
    /// RuntimeFault for more than HEAT_SOURCES sources.
    void write(std::span<const HeatSource> sources, const MetalLattice& lattice, HeatBlock& block);

    /// Sums the weights of the last written sources and leaves the sums bound. Expects the participating tiles to be
    /// listed (HeatTiles), and the temperatures of cells.
    void sum() const;

    size_t bytes() const { return sums_.bytes(); } ///< GPU memory

  private:
    const gl::Program& sum_;
    gl::Buffer sums_; ///< made in each step
    unsigned count_ = 0;
};

} // namespace meltpool
