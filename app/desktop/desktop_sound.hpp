// The lesson's sound as the window's frame drives it: where it comes from, how loud it is, and what the settings say of
// the sound device.
#pragma once

#include "app/session/lesson_session.hpp"
#include "app/session/window_headset.hpp"
#include "app/sound/sound_output.hpp"

#include <string>

namespace meltpool {

class DesktopSound {
  public:
    /// Plays what `session` gives to ears; it must outlive this.
    explicit DesktopSound(LessonSession& session) : output_(session.hearing().ear.feed()) {}

    /// Puts the arc where it is seen from: in the headset (null: none has this frame) at its place in the room, else at
    /// its place in the picture. Neither waits nor allocates but once, when the device is known.
    void update(LessonSession& session, const Controls& controls, const WindowHeadset* headset);
    /// The attempt has been judged: a stick weld is cleaned before it is looked at.
    void judged(LessonSession& session) const;

  private:
    SoundOutput output_;
    bool told_ = false;  ///< the settings say which sound device there is
    std::string device_; ///< what they say, and refer to
};

} // namespace meltpool
