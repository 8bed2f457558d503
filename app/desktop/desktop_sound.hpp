// Drives the lesson's sound from the window's frame: the place of the source, the volume, and the sound device's entry
// in the settings.
#pragma once

#include "app/session/lesson_session.hpp"
#include "app/session/window_headset.hpp"
#include "app/sound/sound_output.hpp"

#include <string>

namespace meltpool {

class DesktopSound {
  public:
    /// Plays the sound of `session`, which must outlive this.
    explicit DesktopSound(LessonSession& session) : output_(session.sound().soundSteps.feed()) {}

    /// Moves the arc's sound to the place where the person sees the arc: in the room with a headset (null: none has
    /// this frame), else in the picture. Neither waits nor allocates, except once, when the device is known.
    void update(LessonSession& session, const Controls& controls, const WindowHeadset* headset);
    /// Plays the chipping of a judged stick weld, which is cleaned before the person looks at it.
    void judged(LessonSession& session) const;

  private:
    SoundOutput output_;
    bool told_ = false;  ///< the settings name the sound device
    std::string device_; ///< name of the device; the settings refer to it
};

} // namespace meltpool
