#include "core/surface/surface_parameters.hpp"

#include <array>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 2> kKernels{"cone", "smooth"};

} // namespace

ParameterList describe(SurfaceParameters& p) {
    return {
        {"cells",
         "Grid cells",
         "",
         &p.cells,
         2,
         128,
         "doubling it costs four to eight times the time and memory",
         {},
         true},
        {"influence", "Particle influence", "cells", &p.influence, 1, 8,
         "a particle adds to (2 i - 1)³ corners: higher is smoother, fatter and slower"},
        {"kernel", "Particle shape", "", &p.kernel, 0, 1,
         "smooth: an even surface, but thinner at the same influence and iso level", kKernels},
        {"iso_level", "Iso level", "", &p.isoLevel, 0.01, 1000,
         "lower makes the metal look fatter, higher opens holes"},
        {"caps", "Caps on the box", "", &p.caps, 0, 1, "off: the metal is open where it touches the box"},
    };
}

} // namespace meltpool
