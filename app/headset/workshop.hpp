// Places things in the headset: the room, the table, the workpiece on it, and the person before it.
#pragma once

#include "app/headset/headset_parameters.hpp"
#include "core/weld/torch/torch_path.hpp"
#include "core/weld/workpiece/position.hpp"
#include "xr/pose.hpp"

#include <optional>

namespace meltpool {

/// Defines a right-handed frame in metres, y up, its origin on the floor under the middle of the workpiece, the welder
/// on the side of +z looking along -z. It keeps its place in the room until it is placed again, see WorkshopPlacing.
class Workshop {
  public:
    /// Distance of the person's eyes behind the workpiece's middle once placed, m.
    static constexpr float kReach = 0.36f;
    /// Drop from the eyes to the table's top, m. With kReach a weld on the table is half a metre from the eyes of a
    /// person who stands or sits upright.
    static constexpr float kDrop = 0.40f;
    /// Lowest and highest table whose height follows from the eyes, m over the floor: for a child on a chair and for a
    /// person of 2.1 m.
    static constexpr float kLowest = 0.5f, kHighest = 1.65f;
    /// Distance of the table's middle behind the workpiece's, m: the person's body is in front of the table's edge.
    static constexpr float kTableBack = 0.12f;

    /// Puts the workshop in front of a head at `head` (session space): turned to its direction, upright. With a known
    /// floor the workshop's floor is the real one. Returns the height of the table's top over the workshop's floor, m:
    /// `setHeight`, or without one kDrop below the eyes.
    float place(const xr::Pose& head, std::optional<float> setHeight, bool floorKnown);

    /// Converts from the session's space to the workshop.
    xr::Pose toWorkshop(const xr::Pose& inSession) const { return sessionToWorkshop_ * inSession; }
    xr::Pose toSession(const xr::Pose& inWorkshop) const { return sessionToWorkshop_.inverse() * inWorkshop; }

  private:
    xr::Pose sessionToWorkshop_;
};

/// Returns the fixture of the lesson as a positioner holds it in the headset: a vertical seam before the face, an
/// overhead one above it, each within reach of the eyes whose table is Workshop::kDrop below them.
Fixture beforeFace(const Fixture& held);

/// Turn and shift of the workpiece before a person who stands upright, so that the torch does not hide the pool: a
/// welder looks past the torch from the side.
struct Stance {
    float turned = 0; ///< rad about the vertical; positive: the workpiece's right end comes nearer
    float aside = 0;  ///< m to the person's left
};

/// Returns no turn if the eyes look at the pool at 40 degrees to the demonstration's torch or more; else the least turn
/// and shift with 50 degrees, or the greatest of 25 degrees and 12 cm. `fixture`: see beforeFace().
Stance stanceFor(const Fixture& fixture, const TorchPath& demonstration);

/// Place of the workpiece on the table, or over it: its own frame (m, origin set by the lesson) enlarged by the zoom
/// and turned as its position and the person's stance require.
struct WorkpiecePlace {
    glm::vec3 origin{0.0f}; ///< origin of the workpiece's frame, in the workshop
    float zoom = 1.0f;
    float overTable = 0;  ///< m from the table's top to the workpiece's lowest place
    glm::mat3 turn{1.0f}; ///< rotation from the workpiece's frame to the workshop's

    /// `bottom`: height of the workpiece's lowest place over its origin, m, with y upwards in the workshop. The
    /// workpiece rests on the table, whose height is in m, or higher by the height of its fixture.
    WorkpiecePlace(float tableHeight, float theZoom, float bottom, const Fixture& held = {}, const Stance& stance = {});

    glm::vec3 toWorkpiece(const glm::vec3& inWorkshop) const {
        return glm::transpose(turn) * ((inWorkshop - origin) / zoom);
    }
    glm::quat toWorkpiece(const glm::quat& inWorkshop) const {
        return glm::quat_cast(glm::transpose(turn)) * inWorkshop;
    }
    glm::vec3 toWorkshop(const glm::vec3& inWorkpiece) const { return origin + turn * inWorkpiece * zoom; }
    /// Matrix from a model that its fixture turned, whose unit is `unit` metres of the workpiece's frame.
    glm::mat4 modelToWorkshop(float unit) const;

  private:
    glm::mat3 stance_{1.0f}; ///< turn of the stance
};

} // namespace meltpool
