// The shapes of workpieces: which places of their frame are metal of the parts, and which are tacks.
#pragma once

#include "core/weld/workpiece/workpiece.hpp"

namespace meltpool {

/// All lengths in mm.
class WorkpieceShape {
  public:
    struct Box {
        glm::vec3 low, high;
    };

    /// Of a simulatedWorkpiece().
    explicit WorkpieceShape(const WorkpieceParameters& simulated);

    /// Boxes that the parts are cut from; they do not overlap.
    const std::vector<Box>& boxes() const { return boxes_; }
    /// Boxes that are wholly metal.
    std::vector<Box> fullBoxes() const;
    /// Box around all parts.
    Box around() const;
    /// Whether a place in one of the boxes is metal.
    bool holds(glm::vec3 place) const;
    /// Of the parts, mm³.
    double volume() const;

    bool held(glm::vec3 place) const; ///< by a clamp
    /// Whether a place that is no metal of the parts belongs to a tack.
    bool inTack(glm::vec3 place) const;
    /// Box around all tacks.
    Box aroundTacks() const;

    /// How far an edge is bevelled back at its upper (outer) face, mm.
    static float bevelRun(const WorkpieceParameters& parameters);
    static float seamLength(const WorkpieceParameters& parameters);
    /// Leg of a tack in a corner, or height of one in a gap, mm.
    static float tackSize(const WorkpieceParameters& parameters);

  private:
    bool is(WorkpieceKind kind) const { return static_cast<WorkpieceKind>(p_.kind) == kind; }
    bool grooved() const { return is(WorkpieceKind::Butt) || is(WorkpieceKind::Pipe); }
    /// A place's section across the seam: across it (z) from the gap's middle, and out of the upper or outer face.
    glm::vec2 sectionOf(glm::vec3 place) const;
    /// Half of the groove's width at this height over the lower (inner) face.
    float halfGroove(float height) const;
    /// Along the seam: of a pipe from its top, right-handed about -z.
    float placeOf(glm::vec3 place) const;
    bool onTack(float place) const;

    WorkpieceParameters p_;
    float gapMiddle_; ///< mm, z
    std::vector<Box> boxes_;
};

} // namespace meltpool
