// The person in the tests of the whole program: stands before the table, holds a torch in one of the scripted hands.
#pragma once

#include "tests/xr/trainer_process.hpp"

#include <functional>
#include <optional>

namespace meltpool::test {

/// Where the runtime puts the grip and the pointer on the scripted device: rigid, so measured once.
struct HandGeometry {
    xr::Pose grip;
    xr::Pose aim;
};
const HandGeometry& handGeometry();

/// A lesson that a software driver keeps up with; what is melted stays so. Writes it into `folder`.
std::filesystem::path smallLesson(const std::filesystem::path& folder);
/// The same with metal in SI units: GMAW on a plate of 24x20x4 mm.
std::filesystem::path plateLesson(const std::filesystem::path& folder);

/// Stands at (0, 1.6, 0) looking along -z when the workshop is placed.
struct Trainee {
    RemoteDriver driver{benchPort()};
    RemoteState state;
    size_t hand = 1;                         ///< that holds the torch: 0 left, 1 right
    std::optional<size_t> pointingHand = {}; ///< at the panel; the torch's hand where none is named
    float zoom = 4;                          ///< as the lesson is shown
    float tableHeight = 0.9f;                ///< m, as set
    float tableTop = 0.9f;                   ///< m, in the session's space
    float bottom = -0.04f;                   ///< lowest place of the lesson's box in the workpiece's frame, m
    glm::quat held = glm::angleAxis(-0.8f, glm::vec3(1, 0, 0)); ///< the torch's orientation

    /// Both hands beside the table, the torch's away from the metal.
    Trainee();

    /// From the workpiece's frame (m) to the session's space.
    glm::vec3 inRoom(const glm::vec3& place) const;
    /// Looks down at the workpiece; the workshop is placed by the first look, straight ahead.
    void lookDown();
    /// Holds the torch's tip at a place of the workpiece's frame.
    void aim(const glm::vec3& place, float trigger);
    /// Pulls the trigger there until `done(row)`. Where the runtime did not answer for a while the arc is out, and the
    /// trigger is let go and pulled again. False after kPatience.
    bool strike(TrainerProcess& trainer, const glm::vec3& place,
                const std::function<bool(const nlohmann::json&)>& done);
    /// The same where the torch is held.
    bool pull(TrainerProcess& trainer, const std::function<bool(const nlohmann::json&)>& done);
    /// Points the pointing hand's ray from a place of the session's space at another.
    void point(const glm::vec3& from, const glm::vec3& target, float trigger);
    /// Holds the ray at a control of the open panel, by its name in the program's telemetry.
    void pointAtControl(TrainerProcess& trainer, const std::string& name, float trigger);
    /// The same at a pixel of the panel.
    void pointAtPixel(float x, float y, float trigger);
    /// Scrolls the panel with the stick until the control is well in sight.
    void scrollTo(TrainerProcess& trainer, const std::string& name);
    /// Scrolls to the control, points at it, pulls the trigger there and lets go, until `done(row)`: where the runtime
    /// did not answer just then, a person would press again. `done` comes true a few frames after the press, and stays.
    void press(TrainerProcess& trainer, const std::string& name,
               const std::function<bool(const nlohmann::json&)>& done);
    /// Presses the pointing hand's menu button where the panel is not open (or closed) yet, until it is.
    void showPanel(TrainerProcess& trainer, bool open);
    /// Lets the trigger go until the program has seen it.
    void letGo(TrainerProcess& trainer);
    void send() { driver.send(state); }
    RemoteHand& pointer() { return state.hands[pointingHand.value_or(hand)]; }

  private:
    bool pullUntil(TrainerProcess& trainer, const std::function<void(float trigger)>& hold,
                   const std::function<bool(const nlohmann::json&)>& done);
};

/// The headset is in use and the lesson runs.
bool running(const nlohmann::json& row);
/// The same, and a pulled trigger counts.
bool ready(const nlohmann::json& row);

/// Waits until so many frames with the headset in use have begun and are over, however slow this machine draws them.
/// While the runtime does not answer, the window's frames know nothing of the hands and do not count.
void passFrames(TrainerProcess& trainer, long long count);
/// Whether `done(row)` comes true within so many frames of that kind.
bool comesTrue(TrainerProcess& trainer, long long count, const std::function<bool(const nlohmann::json&)>& done);

/// The eye (0 left, 1 right) as the compositor shows it once its picture no longer changes from frame to frame.
Image settledEye(TrainerProcess& trainer, int eye);
/// The same of the program's own window.
Image settledWindow(TrainerProcess& trainer);

/// Whether the share of pixels in which an eye differs from `other` fulfils `wanted(share)`, now or within kPatience.
bool eyeComesTo(TrainerProcess& trainer, int eye, const Image& other, const std::function<bool(double)>& wanted);

void sleepFor(double seconds);

} // namespace meltpool::test
