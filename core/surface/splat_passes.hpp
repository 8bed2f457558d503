// The programs that bring particles into the surface's volumes, one for each kind of particle data.
#pragma once

#include "core/gl/program.hpp"

#include <array>
#include <optional>

namespace meltpool {

struct SplatPasses {
    const gl::Program& compare;
    const gl::Program& splatAll;
    const gl::Program& splatChanged;
};

/// Library of programs, one for each kind of data, so that missing data costs nothing; made on first use.
class SplatPassLibrary {
  public:
    explicit SplatPassLibrary(gl::ShaderLibrary& shaders) : shaders_(shaders) {}

    /// Returns the passes. `data`: bits SURFACE_WITH_*; `kernel`: a SurfaceKernel.
    const SplatPasses& passes(int data, int kernel);

  private:
    gl::ShaderLibrary& shaders_;
    // Programs with freezing times or not, with numbers or not, by kernel.
    std::array<std::optional<SplatPasses>, 8> made_;
};

} // namespace meltpool
