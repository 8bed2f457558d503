#include "core/surface/surface_parameters.hpp"

namespace meltpool {

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
        {"iso_level", "Iso level", "", &p.isoLevel, 0.01, 1000,
         "lower wraps the metal more loosely, higher opens holes"},
        {"caps", "Caps on the box", "", &p.caps, 0, 1, "off: the metal is open where it touches the box"},
    };
}

} // namespace meltpool
