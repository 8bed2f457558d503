// Where things stand in the headset: the room, the table, the workpiece on it, and the person before it.
#pragma once

#include "app/headset/torch/headset_parameters.hpp"
#include "xr/session/pose.hpp"

namespace meltpool {

/// The workshop is a right-handed frame in metres, y up, its origin on the floor under the middle of the workpiece, the
/// welder on the side of +z looking along -z. It keeps its place in the room until the person asks for a recentre.
class Workshop {
  public:
    /// Where the person's eyes stand after a recentre: this far behind the workpiece's middle, m.
    static constexpr float kReach = 0.45f;
    /// Seated, the table's top lies this far below the eyes, m.
    static constexpr float kSeatedDrop = 0.45f;

    /// Puts the workshop in front of a head at `head` (session space): turned to where it looks, upright. Standing,
    /// with a known floor, the workshop's floor is the real one; else the table is put before the person.
    void recentre(const xr::Pose& head, const HeadsetParameters& parameters, bool floorKnown);
    /// recentre() is to be called: true at first and after requestRecentre().
    bool recentreRequested() const { return recentreRequested_; }
    void requestRecentre() { recentreRequested_ = true; }

    /// From the session's space into the workshop.
    xr::Pose toWorkshop(const xr::Pose& inSession) const { return sessionToWorkshop_ * inSession; }
    xr::Pose toSession(const xr::Pose& inWorkshop) const { return sessionToWorkshop_.inverse() * inWorkshop; }

  private:
    xr::Pose sessionToWorkshop_;
    bool recentreRequested_ = true;
};

/// The workpiece on the table: its own frame (m, origin where the lesson puts it) enlarged by the zoom.
struct WorkpiecePlace {
    glm::vec3 origin{0.0f}; ///< of the workpiece's frame, in the workshop
    float zoom = 1.0f;

    /// `bottom`: lowest place of the workpiece in its own frame, m; it rests on the table, whose height is in m.
    WorkpiecePlace(float tableHeight, float theZoom, float bottom);

    glm::vec3 toWorkpiece(const glm::vec3& inWorkshop) const { return (inWorkshop - origin) / zoom; }
    glm::vec3 toWorkshop(const glm::vec3& inWorkpiece) const { return origin + inWorkpiece * zoom; }
    /// From a model whose unit is `unit` metres of the workpiece's frame.
    glm::mat4 modelToWorkshop(float unit) const;
};

} // namespace meltpool
