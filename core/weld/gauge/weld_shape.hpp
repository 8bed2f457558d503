// Measures of a ruler, a gauge and a protractor on the outline of a weld: toes, width, height, edge angles, legs and
// throat. Drawn in app/handbook/section-measures.svg.
#pragma once

#include "core/weld/gauge/weld_outline.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace meltpool {

/// A straight face of the workpiece before welding, in a section.
struct PlateFace {
    glm::dvec2 origin{0};   ///< m (z, y), a place on it
    glm::dvec2 along{1, 0}; ///< unit vector on it
    glm::dvec2 out{0, 1};   ///< unit vector out of the plate
};

/// The place at which the weld's surface meets the workpiece's face.
struct WeldToe {
    double place = 0; ///< m along the face from its origin
    /// Angle between face and weld surface, rad, 0 to pi, inside the weld metal; above pi/2 the weld overhangs its toe.
    /// Of a bead: of the circle's arc from the toe to the crown, 2 atan(height / distance of the toe from the crown's
    /// middle). Of a fillet: of the arc from toe to toe. Particles do not resolve the surface nearer to the toe.
    double angle = 0;
};

/// A stretch of a face, m along it from its origin.
struct FaceStretch {
    double low = 0, high = 0;

    double length() const { return high - low; }
};

/// Returns the outline's places as distances along a face and out of it from the face's origin, m.
std::vector<glm::dvec2> inFrame(const WeldOutline& outline, const PlateFace& face);

/// A bead on a level face.
struct BeadShape {
    double height = 0;        ///< m, height of its highest place over the face; 0 below a quarter of a spacing
    double reinforcement = 0; ///< m², cross-section of its metal over the face
    /// Toes at its low and at its high end along the face. None for a bead lower than three quarters of a spacing.
    std::optional<std::array<WeldToe, 2>> toes;
    FaceStretch cover; ///< stretch between its outermost places, which may overhang the toes

    /// Returns the width from toe to toe, m; 0 without toes.
    double toeWidth() const { return toes ? (*toes)[1].place - (*toes)[0].place : 0; }
    /// Returns the overlap at the low and the high end, m: the length of the bead's metal on the face beyond the fused
    /// stretch. Without fusion it is all of the cover, half of it at each end.
    std::array<double, 2> overlap(const std::optional<FaceStretch>& fused) const;
};

/// A fillet in the corner between two faces at right angles.
struct FilletShape {
    double throat = 0; ///< m, least distance from the corner to the weld's surface
    /// Toes on the base plate and on the upright plate; `place` is the leg: the distance from the corner to the toe.
    std::array<WeldToe, 2> toes{};
    double area = 0; ///< m², between the faces and the weld's surface
    /// m, greatest height of the surface over the straight line from toe to toe, between a tenth and nine tenths of
    /// that line; 0 for a hollow surface.
    double convexity = 0;

    double faceWidth() const { return std::hypot(toes[0].place, toes[1].place); }    ///< m, from toe to toe
    double legDifference() const { return std::abs(toes[0].place - toes[1].place); } ///< m
};

/// Measures the bead whose surface rises highest over the face. `spacing`: of the particles that the outline was made
/// from (m), 0 for an exact outline. The particles' size rounds the corner between face and bead, so a toe is
/// extrapolated from the surface three quarters to one and three quarters of a spacing over the face, continued to the
/// face along the arc.
BeadShape measureBead(const WeldOutline& outline, const PlateFace& face, double spacing);

/// Measures the fillet in the corner at the face's origin; the face is that of the base plate, and the other one goes
/// up along its `out`. The flanks go up to three quarters of the other leg. Nothing if the weld's surface is nearer to
/// the corner than 1.1 spacings.
std::optional<FilletShape> measureFillet(const WeldOutline& outline, const PlateFace& base, double spacing);

} // namespace meltpool
