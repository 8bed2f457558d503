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
         "Twice the cells cost four to eight times the time and memory.",
         {},
         true},
        {"influence", "Particle influence", "cells", &p.influence, 1, 8,
         "A particle adds to (2 i - 1)³ corners. Higher is smoother, fatter and slower."},
        {"kernel", "Particle shape", "", &p.kernel, 0, 1,
         "Smooth gives an even surface, but a thinner one at equal influence and iso level.", kKernels},
        {"iso_level", "Iso level", "", &p.isoLevel, 0.01, 1000,
         "A lower level makes the metal look fatter. A higher level opens holes."},
        {"caps", "Caps on the box", "", &p.caps, 0, 1, "Off: the metal is open where it touches the box."},
    };
}

} // namespace meltpool
