// The torch that mouse and keys lead at the desk: along and across the seam, at a held distance from the plate.
#pragma once

#include "app/session/heat_source.hpp"
#include "core/training/judging/seam.hpp"
#include "core/training/judging/technique.hpp"
#include "core/weld/torch/hand_tremor.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <glm/mat3x3.hpp>

#include <optional>

namespace meltpool {

struct Lesson;
struct ProcessSettings;

/// Where a torch is held against the seam; angles and signs as in the technique that is measured.
struct DeskPose {
    double place = 0;    ///< m along the seam
    double aim = 0;      ///< m across it
    double distance = 0; ///< m from contact tip or electrode to the seam's height, along the torch
    double work = 0;     ///< rad
    double travel = 0;   ///< rad, positive pushes where the torch goes towards growing places
    double dip = 0;      ///< of a filler rod: 0 at rest, 1 in the pool
};

/// What a frame is like beside the hand's input.
struct DeskFrame {
    glm::mat3 toScreen{1}; ///< rotates directions of the workpiece's frame into the view, x right and y up
    double seconds = 0;    ///< of real time since the last frame
};

/// Once a frame the hand says where the torch goes to; the steps of the frame lead it there evenly. The height follows
/// the workpiece as it was before welding, not the bead that grows: the mouse cannot feel metal.
class DeskTorch {
  public:
    /// Over the beginning of what the lesson's technique wants welded, held as it asks for, a contact tip as far away
    /// as in the demonstration; nothing to lead in a lesson of the classic model.
    void begin(const Lesson& lesson);
    /// At this place along the seam (m), held as it was.
    void standAt(double place);
    /// There is a seam to lead it along.
    bool leads() const { return seam_.has_value(); }

    /// Takes a frame's input. A moving mouse goes along and across the seam as they lie on the screen; a wheel notch is
    /// 0.5 mm of distance, an arrow key 1 degree of travel (left, right) or work angle (up, down), a page key 0.5 mm of
    /// distance. A gamepad's left stick leads like the mouse and its right stick leans the handle as it lies on the
    /// screen; its shoulders change the distance and its left trigger dips the rod. With a guide speed the torch goes
    /// on by itself while it welds, in the metal's time, as far as it can be led. `process`: as it is set now; a
    /// contact tip stays where it is when the stick-out is set anew.
    void update(const InputFrame& input, const DeskFrame& frame, const ControlParameters& parameters,
                const ProcessSettings& process);

    /// The torch at the end of step `step` of `due` steps (0 <= step < due), each of `seconds`. `burntOff`: see
    /// Process::burntOff(). `trigger`: 0 to 1; a mouse has no more than these two.
    TorchSample next(int step, int due, double seconds, float burntOff, float trigger);

    const DeskPose& pose() const { return wanted_; }
    /// What DeskPose::distance is called, and whether a rod is held.
    DistanceKind distanceKind() const { return kind_; }
    bool hasRod() const { return rod_; }
    /// The guide has led it since begin().
    bool guided() const { return guided_; }

  private:
    void take(const ProcessSettings& process);
    void lead(const glm::vec2& way, const glm::mat3& toScreen);
    void takeKeys(const InputFrame& input);
    void takeGamepad(const GamepadFrame& gamepad, const DeskFrame& frame, double speed);
    double wayLeft() const;
    TorchSample sampleOf(const DeskPose& pose, float burntOff) const;
    RodSample rodOf(const TorchSample& torch, const DeskPose& pose, const SeamFrame& frame) const;

    std::optional<Seam> seam_;
    DistanceKind kind_ = DistanceKind::ctwd;
    double stickOut_ = 0; ///< m, see heldBehind()
    bool rod_ = false;
    double guide_ = 0;  ///< m/s
    double tremor_ = 0; ///< in that of a practised hand
    double time_ = 0;   ///< s of the metal since begin()
    HandTremor hand_{1};
    bool guided_ = false;
    DeskPose wanted_; ///< by the hand
    DeskPose held_;   ///< at the last step
    double left_ = 0; ///< m that the guide has gone beyond the hand's own way
};

} // namespace meltpool
