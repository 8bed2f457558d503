// The torch that mouse and keys lead at the desk: along and across the seam, at a held distance from the plate.
#pragma once

#include "app/session/heat_source.hpp"
#include "core/training/technique/seam.hpp"
#include "core/training/technique/technique.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <glm/mat3x3.hpp>

#include <optional>

namespace meltpool {

struct Lesson;

/// Where a torch is held against the seam; angles and signs as in the technique that is measured.
struct DeskPose {
    double place = 0;    ///< m along the seam
    double aim = 0;      ///< m across it
    double distance = 0; ///< m from contact tip or electrode to the seam's height, along the torch
    double work = 0;     ///< rad
    double travel = 0;   ///< rad, positive pushes where the torch goes towards growing places
    double dip = 0;      ///< of a filler rod: 0 at rest, 1 in the pool
};

/// Once a frame the hand says where the torch goes to; the steps of the frame lead it there evenly. The height follows
/// the workpiece as it was before welding, not the bead that grows: the mouse cannot feel metal.
class DeskTorch {
  public:
    /// Over the beginning of what the lesson's technique wants welded, held as it asks for; nothing to lead in a lesson
    /// of the classic model.
    void begin(const Lesson& lesson);
    /// There is a seam to lead it along.
    bool leads() const { return seam_.has_value(); }

    /// Takes a frame's input. `toScreen`: rotates directions of the workpiece's frame into the view, x right and y up.
    /// A moving mouse goes along and across the seam as they lie on the screen; a wheel notch is 0.5 mm of distance, an
    /// arrow key 1 degree of travel (left, right) or work angle (up, down), a page key 0.5 mm of distance. With a guide
    /// speed the torch goes on by itself while it welds, in the metal's time.
    void update(const InputFrame& input, const glm::mat3& toScreen, const ControlParameters& parameters);

    /// The torch at the end of step `step` of `due` steps (0 <= step < due), each of `seconds`. `burntOff`: see
    /// Process::burntOff(). `trigger`: 0 or 1.
    TorchSample next(int step, int due, double seconds, float burntOff, float trigger);

    const DeskPose& pose() const { return wanted_; }
    /// What DeskPose::distance is called, and whether a rod is held.
    DistanceKind distanceKind() const { return kind_; }
    bool holdsRod() const { return rod_; }
    /// The guide has led it since begin().
    bool guided() const { return guided_; }

  private:
    TorchSample sampleOf(const DeskPose& pose, float burntOff) const;
    RodSample rodOf(const TorchSample& torch, const DeskPose& pose, const SeamFrame& frame) const;

    std::optional<Seam> seam_;
    DistanceKind kind_ = DistanceKind::ctwd;
    double stickOut_ = 0; ///< m that the pose's tip lies before what the distance is measured from
    bool rod_ = false;
    double guide_ = 0; ///< m/s
    bool guided_ = false;
    DeskPose wanted_; ///< by the hand
    DeskPose held_;   ///< at the last step
    double left_ = 0; ///< m that the guide has gone beyond the hand's own way
};

} // namespace meltpool
