// The shapes of workpieces: places of their frame in the metal of the parts and in tacks.
#pragma once

#include "core/weld/workpiece/workpiece.hpp"

namespace meltpool {

/// Shape of a workpiece; all lengths in mm.
class WorkpieceShape {
  public:
    struct Box {
        glm::vec3 low, high;
    };

    /// Takes a simulatedWorkpiece().
    explicit WorkpieceShape(const WorkpieceParameters& simulated);

    /// Returns the boxes that the parts are cut from; they do not overlap.
    const std::vector<Box>& boxes() const { return boxes_; }
    /// Returns the boxes that are wholly metal.
    std::vector<Box> fullBoxes() const;
    /// Returns the box around all parts.
    Box around() const;
    /// Returns true if a place in one of the boxes is metal.
    bool holds(glm::vec3 place) const;
    /// Returns the volume of the parts, mm³.
    double volume() const;

    bool held(glm::vec3 place) const; ///< true at a clamp
    /// Returns true if a place outside the parts' metal belongs to a tack.
    bool inTack(glm::vec3 place) const;
    /// Returns the box around all tacks.
    Box aroundTacks() const;

    /// Returns the depth of an edge's bevel at its upper (outer) face, mm.
    static float bevelRun(const WorkpieceParameters& parameters);
    static float seamLength(const WorkpieceParameters& parameters);
    /// Returns the leg of a tack in a corner, or the height of one in a gap, mm.
    static float tackSize(const WorkpieceParameters& parameters);

  private:
    bool is(WorkpieceKind kind) const { return static_cast<WorkpieceKind>(p_.kind) == kind; }
    bool grooved() const { return is(WorkpieceKind::Butt) || is(WorkpieceKind::Pipe); }
    /// Returns a place's section across the seam: distance (z) from the gap's middle, and height out of the upper or
    /// outer face.
    glm::vec2 sectionOf(glm::vec3 place) const;
    /// Returns half of the groove's width at this height over the lower (inner) face.
    float halfGroove(float height) const;
    /// Returns the place along the seam: of a pipe from its top, right-handed about -z.
    float placeOf(glm::vec3 place) const;
    bool onTack(float place) const;

    WorkpieceParameters p_;
    float gapMiddle_; ///< mm, z
    std::vector<Box> boxes_;
};

} // namespace meltpool
