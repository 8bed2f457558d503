// Effects of keys and mouse in the window: modes, cameras and the heat source. Knows no window library.
#pragma once

#include "app/session/heat_source.hpp"
#include "app/session/trigger_lock.hpp"
#include "core/render/camera.hpp"

namespace meltpool {

enum class Mode {
    interact, ///< the simulation runs, the camera orbits the metal, the mouse holds the source
    view      ///< the lesson is paused, also for a hand in the headset; the camera flies, the mouse turns it
};

class Controls {
  public:
    ControlParameters parameters;
    Lens lens;

    /// Applies `seconds` of input. V changes the mode, C captures or frees the mouse, Escape frees it. A captured mouse
    /// moves the source (or turns the camera); a free one does so while a button is held on the picture. After a reset,
    /// a change of mode and a captured or freed mouse, the left button heats only once it has been released; so does a
    /// gamepad's right trigger.
    /// With ControlParameters::spaceLatch the space bar switches the heat on and off; whatever locks the trigger, and
    /// another window with the keyboard, switch it off.
    void update(const InputFrame& input, double seconds);

    /// Moves the source back to its start and switches it off; cameras and mode stay.
    void reset() {
        putOut(ArcOut::lessonBegan);
        source_.reset();
    }
    /// Resets to interact mode with a free mouse, and source and cameras to their start.
    void restart();
    /// Sets the start of the orbiting camera.
    void placeCamera(const OrbitCamera& camera) { orbit_ = camera; }
    /// Makes mouse, wheel, arrow and page keys lead a torch along a seam instead of moving the source.
    void leadTorch(bool leads) { leadsTorch_ = leads; }
    /// Input for that torch in this frame; without the wheel if that moves the camera.
    const InputFrame& hand() const { return hand_; }
    /// Travel of that torch's trigger, 0..1: 1 for the mouse's left button, a gamepad's right trigger as far as it is
    /// pulled.
    float trigger() const { return trigger_; }

    void releaseMouse() { capture(false); }
    /// Releases a locked mouse until takeBackMouse().
    void lendMouse();
    /// Locks the mouse again that was lent, unless the person has locked or freed it since.
    void takeBackMouse();
    void captureMouse() { capture(true); }
    void setMode(Mode mode);
    /// Switches the source off until the left button is released.
    void putOut(ArcOut reason) {
        lock_.lock(reason);
        latched_ = false;
        pull(0);
    }

    Mode mode() const { return mode_; }
    bool captured() const { return captured_; }
    const TriggerLock& triggerLock() const { return lock_; }
    SteeredSource& source() { return source_; }
    const SteeredSource& source() const { return source_; }

    View view(float aspect) const;
    glm::vec3 eye() const;
    glm::vec3 forward() const;
    const FreeCamera& freeCamera() const { return free_; }
    const OrbitCamera& orbitCamera() const { return orbit_; }

  private:
    void pull(float trigger);
    bool weldsByDesk(const InputFrame& input) const;
    float pulled(const InputFrame& input) const;
    void capture(bool captured);
    void work(const InputFrame& input, float seconds);
    void look(const InputFrame& input, float seconds);

    Mode mode_ = Mode::interact;
    bool captured_ = false;
    bool lent_ = false; ///< free until takeBackMouse()
    bool leadsTorch_ = false;
    bool latched_ = false; ///< the space bar has switched the heat on
    InputFrame hand_;
    float trigger_ = 0;
    FreeCamera free_;
    OrbitCamera orbit_;
    SteeredSource source_;
    TriggerLock lock_;
};

} // namespace meltpool
