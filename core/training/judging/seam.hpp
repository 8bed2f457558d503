// Defines the line to weld, with its directions at every place: the reference of technique.
#pragma once

#include "core/weld/workpiece/workpiece.hpp"

#include <glm/vec3.hpp>

namespace meltpool {

/// Directions at one place of a seam, in the workpiece's frame. All three are unit vectors at right angles.
struct SeamFrame {
    glm::dvec3 point{0};         ///< m
    glm::dvec3 tangent{1, 0, 0}; ///< towards growing places
    glm::dvec3 up{0, 1, 0};      ///< out of the joint, along the bisector of its faces
    glm::dvec3 across{0, 0, 1};  ///< tangent x up; on the straight joints the welder's side (+z) is positive
};

/// Position of a point relative to a seam, m.
struct SeamPlace {
    double place = 0;  ///< along the seam
    double across = 0; ///< along SeamFrame::across
    double height = 0; ///< along SeamFrame::up
};

/// A straight or a circular line in the workpiece's frame. Places count in m along it. On a straight seam of a
/// workpiece the place is the coordinate x; a circle's places begin at 0 and return there after one turn.
class Seam {
  public:
    /// A straight seam from place `begin` to `end` (m) on the line through `zero`, which has place 0. `tangent` and
    /// `up` need not be unit vectors nor at right angles; they must not be parallel.
    static Seam line(const glm::dvec3& zero, const glm::dvec3& tangent, const glm::dvec3& up, double begin, double end);

    /// A seam once around `axis` through `centre`, beginning at `start`, right-handed about the axis. `up` is the
    /// radius. `start` must not be on the axis.
    static Seam circle(const glm::dvec3& centre, const glm::dvec3& axis, const glm::dvec3& start);

    /// The frame at any place, also beyond the ends; on a circle places repeat after each turn.
    SeamFrame at(double place) const;

    /// The place whose cross-section contains the point. On a circle 0 <= place < length().
    SeamPlace nearest(const glm::dvec3& point) const;

    double begin() const { return begin_; }
    double end() const { return end_; }
    double length() const { return end_ - begin_; }
    /// True for a circle, whose end is its beginning.
    bool closed() const { return radius_ > 0; }

  private:
    Seam() = default;

    SeamFrame zero_;       ///< frame at place 0
    glm::dvec3 centre_{0}; ///< centre of a circle
    glm::dvec3 axis_{0, 0, 1};
    double radius_ = 0; ///< m; 0: straight
    double begin_ = 0;
    double end_ = 0;
};

/// The seam of a workpiece, as simulated, from end to end. Plate and bridge: the middle of the upper face, up is +y.
/// Cube: the middle of its upper face. Butt: the middle of the gap, up is +y. Tee, lap and outside corner: the line
/// where the two welded faces meet, up is (0, 1, 1)/sqrt(2). Pipe: once around the middle of the gap on the outer face,
/// beginning at the top towards +x.
Seam seamOf(const WorkpieceParameters& asked);

/// The point where the axis (unit vector) of a torch with this tip (m) meets the height of the seam; the tip itself if
/// the torch is too flat for that.
glm::dvec3 footOf(const Seam& seam, const glm::dvec3& tip, const glm::dvec3& axis);

} // namespace meltpool
