// Places things in the headset: the room, the table, the workpiece on it, and the person before it.
#pragma once

#include "app/headset/headset_parameters.hpp"
#include "core/weld/workpiece/position.hpp"
#include "xr/pose.hpp"

namespace meltpool {

/// Defines a right-handed frame in metres, y up, its origin on the floor under the middle of the workpiece, the welder
/// on the side of +z looking along -z. It keeps its place in the room until the person asks for a recentre.
class Workshop {
  public:
    /// Distance of the person's eyes behind the workpiece's middle after a recentre, m.
    static constexpr float kReach = 0.45f;
    /// Drop from the eyes to the table's top when seated, m.
    static constexpr float kSeatedDrop = 0.45f;

    /// Puts the workshop in front of a head at `head` (session space): turned to its direction, upright. When standing,
    /// with a known floor, the workshop's floor is the real one; else the table is put before the person.
    void recentre(const xr::Pose& head, const HeadsetParameters& parameters, bool floorKnown);
    /// Returns true if recentre() is due: at first and after requestRecentre().
    bool recentreRequested() const { return recentreRequested_; }
    void requestRecentre() { recentreRequested_ = true; }

    /// Converts from the session's space to the workshop.
    xr::Pose toWorkshop(const xr::Pose& inSession) const { return sessionToWorkshop_ * inSession; }
    xr::Pose toSession(const xr::Pose& inWorkshop) const { return sessionToWorkshop_.inverse() * inWorkshop; }

  private:
    xr::Pose sessionToWorkshop_;
    bool recentreRequested_ = true;
};

/// Place of the workpiece on the table, or over it: its own frame (m, origin set by the lesson) enlarged by the zoom
/// and turned as its position requires.
struct WorkpiecePlace {
    glm::vec3 origin{0.0f}; ///< origin of the workpiece's frame, in the workshop
    float zoom = 1.0f;
    glm::mat3 turn{1.0f}; ///< rotation from the workpiece's frame to the workshop's

    /// `bottom`: height of the workpiece's lowest place over its origin, m, with y upwards in the workshop. The
    /// workpiece rests on the table, whose height is in m, or higher by the height of its fixture.
    WorkpiecePlace(float tableHeight, float theZoom, float bottom, const Fixture& held = {});

    glm::vec3 toWorkpiece(const glm::vec3& inWorkshop) const {
        return glm::transpose(turn) * ((inWorkshop - origin) / zoom);
    }
    glm::quat toWorkpiece(const glm::quat& inWorkshop) const {
        return glm::quat_cast(glm::transpose(turn)) * inWorkshop;
    }
    glm::vec3 toWorkshop(const glm::vec3& inWorkpiece) const { return origin + turn * inWorkpiece * zoom; }
    /// Matrix from a turned model whose unit is `unit` metres of the workpiece's frame.
    glm::mat4 modelToWorkshop(float unit) const;
};

} // namespace meltpool
