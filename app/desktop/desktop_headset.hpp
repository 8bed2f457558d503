// The headset beside the window: the frames that it paces, and the first of them.
#pragma once

#include "app/desktop/desktop.hpp"
#include "app/session/window_headset.hpp"

#include <filesystem>
#include <memory>

namespace meltpool {

class DesktopHeadset {
  public:
    /// Makes the headset unless the options want none. The window's OpenGL context is current; `folder` keeps
    /// calibrations.
    void open(const DesktopOptions& options, const std::filesystem::path& folder);

    /// Begins a frame, see WindowHeadset::begin(), and holds the headset's warning among the messages. True in the
    /// first frame of somebody who puts the headset on. `now` is s on the program's clock. Throws InputError where a
    /// headset that was wanted does not come.
    bool begin(LessonSession& session, const Home& home, Messages& messages, double seconds, double now);

    /// Null: there is no headset.
    WindowHeadset* device() const { return headset_.get(); }
    /// The headset that paces this frame; null: the window does.
    WindowHeadset* inFrame() const { return frame_ ? headset_.get() : nullptr; }

  private:
    std::unique_ptr<WindowHeadset> headset_;
    bool wanted_ = false;  ///< without one the program ends
    bool frame_ = false;   ///< the headset paces this frame
    bool started_ = false; ///< it has had frames before
};

} // namespace meltpool
