// The torch that mouse and keys lead at the desk: along and across the seam, at a held distance from the plate.
#pragma once

#include "app/session/desk_weave.hpp"
#include "app/session/heat_source.hpp"
#include "core/training/feedback/cues.hpp"
#include "core/training/judging/seam.hpp"
#include "core/training/judging/technique.hpp"
#include "core/weld/torch/hand_tremor.hpp"
#include "core/weld/torch/torch_moves.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>

#include <optional>

namespace meltpool {

struct Lesson;
struct ProcessSettings;

/// Pose of a torch against the seam; angles and signs as in the measured technique.
struct DeskPose {
    double place = 0;    ///< m along the seam
    double aim = 0;      ///< m across the seam
    double distance = 0; ///< m from contact tip or electrode to the metal's expected height, along the torch
    double work = 0;     ///< rad
    double travel = 0;   ///< rad; positive pushes while the torch travels towards greater places
    double dip = 0;      ///< dip of a filler rod: 0 at rest, 1 in the pool
};

/// Conditions of a frame other than the hand's input.
struct DeskFrame {
    glm::mat3 toScreen{1}; ///< rotates directions of the workpiece's frame into the view, x right and y up
    /// Metal's time of the frame, s: keys and sticks lead at one speed over the metal on a slow computer too.
    double seconds = 0;
};

/// Torch of the desk. Once a frame the input sets its target; the steps of the frame move it there evenly. The mouse
/// cannot feel metal: a contact tip's height follows the workpiece as it was before welding and, while the trigger is
/// pulled, rises to the height of the demonstration over its pool.
class DeskTorch {
  public:
    /// Places the torch over the beginning of what the lesson's technique wants welded, at the asked angles and
    /// distance; leads nothing in a lesson of the classic model.
    void begin(const Lesson& lesson);
    /// Moves the torch to this place along the seam (m); its pose stays.
    void standAt(double place);
    /// Puts the torch aside, out of the picture, as soon as its trigger and the keys that lead it are let go, until the
    /// hand leads it or pulls its trigger again.
    void putAside() { asideAsked_ = true; }
    bool aside() const { return aside_; }
    /// True if there is a seam.
    bool leads() const { return seam_.has_value(); }

    /// Takes a frame's input. Mouse travel on the screen becomes travel along and across the seam; a wheel notch is 0.5
    /// mm of distance, an arrow key 1 degree of travel (left, right) or work angle (up, down), a page key 0.5 mm of
    /// distance. Arrow keys held with Shift lead the torch at the keys' speed: left and right along the seam,
    /// up and down across it, or the other way round where the seam is steep on the screen. A gamepad's left stick
    /// leads on the screen, in a push nearly along the seam exactly along it, and its right stick leans the handle; its
    /// shoulders change the distance and its left trigger dips the rod. With a guide speed the torch travels by itself
    /// while it welds, in the metal's time, up to the end of its range. G switches the swings of the demonstration on
    /// and off, if it has any. `process`: settings now; a contact tip does not
    /// move when the stick-out changes.
    void update(const InputFrame& input, const DeskFrame& frame, const ControlParameters& parameters,
                const ProcessSettings& process);

    /// Torch at the end of step `step` of `due` steps (0 <= step < due), each of `seconds`. `burntOff`: see
    /// Process::burntOff(). `trigger`: 0 to 1; a mouse has only these two.
    TorchSample next(int step, int due, double seconds, float burntOff, float trigger);

    const DeskPose& pose() const { return wanted_; }
    /// Torch in that pose. Requires leads().
    TorchSample sample() const { return sampleOf(wanted_, 0, 0); }
    /// Kind of DeskPose::distance, and true if a rod is held.
    DistanceKind distanceKind() const { return kind_; }
    bool hasRod() const { return rod_; }
    /// True if the guide has led the torch since begin().
    bool guided() const { return guided_; }
    /// Swings that the torch makes by itself.
    const DeskWeave& weave() const { return weave_; }
    /// Quantities that the hand has not led while it welded since begin(): the desk held them.
    QuantitySet held() const;

  private:
    void take(const ProcessSettings& process);
    void lead(const glm::vec2& way, const glm::mat3& toScreen);
    void takeKeys(const InputFrame& input);
    void leadByKeys(const InputFrame& input, const DeskFrame& frame, double speed);
    void takeGamepad(const GamepadFrame& gamepad, const DeskFrame& frame, double speed);
    double wayLeft() const;
    void noteLed(const DeskPose& target);
    TorchSample sampleOf(const DeskPose& pose, float burntOff, double swing) const;
    RodSample rodOf(const TorchSample& torch, const DeskPose& pose, const SeamFrame& frame) const;

    std::optional<Seam> seam_;
    DistanceKind kind_ = DistanceKind::ctwd;
    double stickOut_ = 0; ///< m, see heldBehind()
    bool rod_ = false;
    double guide_ = 0;  ///< m/s
    double tremor_ = 0; ///< multiple of a practised hand's tremor
    double time_ = 0;   ///< s of the metal since begin()
    HandTremor hand_{1};
    bool guided_ = false;
    bool asideAsked_ = false; ///< see putAside()
    bool aside_ = false;
    bool stirs_ = false; ///< the hand moved it in the last frame
    DeskWeave weave_;
    RodHold hold_;              ///< the demonstration's hold of the rod; its feed is that of a dipped one
    QuantitySet led_;           ///< quantities that the hand has led while it welded
    DeskPose wanted_;           ///< target that the hand sets
    DeskPose held_;             ///< pose at the last step
    double pool_ = 0;           ///< m by which the demonstration is held higher, over its pool
    double rise_ = 0;           ///< m of that which this torch has risen
    double askedSpeed_ = 0;     ///< m/s, travel speed that the lesson asks for
    bool keysKeepPace_ = false; ///< the keys lead along the seam at that speed
    bool paced_ = false;        ///< and did so while the torch welded, since begin()
    glm::dvec2 keyPace_{0};     ///< share of the keys' speed along and across the seam
    glm::dmat2 keyWays_{0};     ///< turns held arrows, x right and y up, into ways along and across
    double left_ = 0;           ///< m that the guide went beyond the hand's own way
};

} // namespace meltpool
