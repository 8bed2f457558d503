// Pressure of an arc on the metal. A header of its own: every process sets it without knowing the flow.
#pragma once

#include <glm/vec3.hpp>

namespace meltpool {

/// Pressure of an arc on the surface that faces it: peak exp(-r²/(2 sigma²)) around its axis.
struct ArcPressure {
    glm::vec3 place{0};       ///< m, on the axis
    glm::vec3 axis{0, -1, 0}; ///< unit vector into the metal
    float sigma = 2e-3F;      ///< m
    float peak = 0;           ///< Pa
    float shear = 0;          ///< Pa, peak drag of the arc's jet along the surface, away from the axis
};

} // namespace meltpool
