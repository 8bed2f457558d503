// Drives the headset next to the window: the frames that it paces, and the first of them.
#pragma once

#include "app/desktop/desktop.hpp"
#include "app/session/window_headset.hpp"

#include <filesystem>
#include <memory>

namespace meltpool {

class DesktopHeadset {
  public:
    /// Makes the headset unless the options exclude one. The window's OpenGL context is current; `folder` stores
    /// calibrations.
    void open(const DesktopOptions& options, const std::filesystem::path& folder);

    /// Begins a frame, see WindowHeadset::begin(), and holds the headset's warning among the messages. Returns true in
    /// the first frame after a person puts the headset on. `now` is s on the program's clock. Throws InputError if a
    /// requested headset does not come.
    bool begin(LessonSession& session, const Home& home, Messages& messages, double seconds, double now);

    /// Returns null without a headset.
    WindowHeadset* device() const { return headset_.get(); }
    /// Returns the headset that paces this frame, or null if the window paces it.
    WindowHeadset* inFrame() const { return frame_ ? headset_.get() : nullptr; }

  private:
    std::unique_ptr<WindowHeadset> headset_;
    bool wanted_ = false;  ///< the program ends without a headset
    bool frame_ = false;   ///< the headset paces this frame
    bool started_ = false; ///< the headset has had frames before
};

} // namespace meltpool
