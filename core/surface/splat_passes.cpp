#include "core/surface/splat_passes.hpp"

#include "core/surface/surface_parameters.hpp"
#include "shaders/shared/surface.h"

namespace meltpool {

const SplatPasses& SplatPassLibrary::passes(int data, int kernel) {
    const bool freezing = (data & SURFACE_WITH_FREEZING) != 0, numbered = (data & SURFACE_WITH_NUMBERS) != 0;
    const bool smooth = kernel == static_cast<int>(SurfaceKernel::smooth);
    auto& chosen = made_[(freezing ? 1U : 0U) + (numbered ? 2U : 0U) + (smooth ? 4U : 0U)];
    if (chosen) return *chosen;
    gl::Defines read;
    if (freezing) read["SURFACE_FREEZING"] = "1";
    if (numbered) read["SURFACE_NUMBERED"] = "1";
    gl::Defines changed = read;
    if (smooth) changed["SURFACE_SMOOTH"] = "1";
    gl::Defines all = changed;
    all["SURFACE_REBUILD"] = "1";
    return chosen.emplace(SplatPasses{shaders_.compute("surface/compare.comp", read),
                                      shaders_.compute("surface/splat.comp", all),
                                      shaders_.compute("surface/splat.comp", changed)});
}

} // namespace meltpool
