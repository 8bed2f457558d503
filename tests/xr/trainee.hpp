// Imitates the person in the tests of the whole program, in front of the table with a torch in one of the scripted
// hands.
#pragma once

#include "app/headset/workshop.hpp"
#include "core/scene/torch_geometry.hpp"
#include "tests/xr/trainer_process.hpp"

#include <functional>
#include <optional>
#include <string_view>

namespace meltpool::test {

/// Offset of the runtime's grip and pointer from the scripted device: rigid, so measured once.
struct HandGeometry {
    xr::Pose grip;
    xr::Pose aim;
};
const HandGeometry& handGeometry();

/// Writes a lesson into `folder` with which a software driver keeps pace; its molten metal stays molten.
std::filesystem::path smallLesson(const std::filesystem::path& folder);
/// Writes a lesson with metal in SI units: GMAW on a plate of 24x20x4 mm.
std::filesystem::path plateLesson(const std::filesystem::path& folder);

/// Starts at (0, 1.6, 0) looking along -z when the workshop is placed.
struct Trainee {
    RemoteDriver driver{driverPort()};
    RemoteState state;
    size_t hand = 1;                            ///< hand with the torch: 0 left, 1 right
    std::optional<size_t> pointingHand = {};    ///< hand that points at the panel; the torch's hand if empty
    float zoom = 4;                             ///< zoom of the lesson
    float tableHeight = 1.6f - Workshop::kDrop; ///< m over the workshop's floor
    float tableTop = 1.6f - Workshop::kDrop;    ///< m, in the session's space
    Fixture fixture = {};                       ///< of the lesson, before the person's face
    Stance stance = {};                         ///< of the lesson
    float bottom = -0.04f;                      ///< lowest place of the lesson's box in the workpiece's frame, m
    TorchGeometry torch = kPlainTorch;          ///< the lesson's torch, whose own tip counts
    glm::quat held = glm::angleAxis(-0.8f, glm::vec3(1, 0, 0)); ///< the torch's orientation

    /// Puts both hands next to the table, the torch's away from the metal.
    Trainee();

    /// Converts from the workpiece's frame (m) to the session's space.
    glm::vec3 inRoom(const glm::vec3& place) const;
    /// Takes the torch of a process into the hand, by the process's name in lessons.
    void take(std::string_view process);
    /// Looks down at the workpiece; the first look, straight ahead, places the workshop.
    void lookDown();
    /// Holds the torch's tip at a place of the workpiece's frame.
    void aim(const glm::vec3& place, float trigger);
    /// Pulls the trigger there until `done(row)`. After a gap of the runtime the arc is out, and the trigger is
    /// released and pulled again. False after kPatience.
    bool strike(TrainerProcess& trainer, const glm::vec3& place,
                const std::function<bool(const nlohmann::json&)>& done);
    /// Pulls the trigger at the torch's current place until `done(row)`, as strike().
    bool pull(TrainerProcess& trainer, const std::function<bool(const nlohmann::json&)>& done);
    /// Points the pointing hand's ray from a place of the session's space at another.
    void point(const glm::vec3& from, const glm::vec3& target, float trigger);
    /// Holds the ray at a control of the open panel, by its name in the program's telemetry.
    void pointAtControl(TrainerProcess& trainer, const std::string& name, float trigger);
    /// Holds the ray at a pixel of the panel.
    void pointAtPixel(TrainerProcess& trainer, float x, float y, float trigger);
    /// Scrolls the panel with the stick until the control is well in sight.
    void scrollTo(TrainerProcess& trainer, const std::string& name);
    /// Scrolls to the control, points at it, pulls the trigger and releases it, until `done(row)`: a person would press
    /// again if the runtime did not answer just then. `done` comes true a few frames after the press, and stays.
    void press(TrainerProcess& trainer, const std::string& name,
               const std::function<bool(const nlohmann::json&)>& done);
    /// Presses the pointing hand's menu button until the panel is open (or closed).
    void showPanel(TrainerProcess& trainer, bool open);
    /// Holds the stick of the left hand in until the workshop has come.
    void holdStick(TrainerProcess& trainer);
    /// Releases the trigger until the program has seen it.
    void letGo(TrainerProcess& trainer);
    void send() { driver.send(state); }
    RemoteHand& pointer() { return state.hands[pointingHand.value_or(hand)]; }

  private:
    WorkpiecePlace workpiece() const { return {tableTop, zoom, bottom, fixture, stance}; }
    bool pullUntil(TrainerProcess& trainer, const std::function<void(float trigger)>& hold,
                   const std::function<bool(const nlohmann::json&)>& done);
};

/// Returns true if the headset is in use and the lesson runs.
bool running(const nlohmann::json& row);
/// Returns true if, in addition to running(), a pulled trigger counts.
bool ready(const nlohmann::json& row);

/// Waits until so many frames with the headset in use have begun and ended, however slow this machine draws them. While
/// the runtime does not answer, the window's frames know nothing of the hands and do not count.
void passFrames(TrainerProcess& trainer, long long count);
/// Returns true if `done(row)` comes true within so many frames of that kind.
bool comesTrue(TrainerProcess& trainer, long long count, const std::function<bool(const nlohmann::json&)>& done);

/// Takes the eye's picture (0 left, 1 right) as the compositor shows it, once it no longer changes from frame to frame.
Image settledEye(TrainerProcess& trainer, int eye);
/// Takes the program's own window once it no longer changes from frame to frame.
Image settledWindow(TrainerProcess& trainer);

/// Returns true if the share of pixels in which an eye differs from `other` fulfils `wanted(share)`, now or within
/// kPatience.
bool eyeComesTo(TrainerProcess& trainer, int eye, const Image& other, const std::function<bool(double)>& wanted);

void sleepFor(double seconds);

} // namespace meltpool::test
