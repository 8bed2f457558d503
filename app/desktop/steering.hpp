// Presses Dear ImGui's keys for the gamepad, for the program itself, and for taps that Dear ImGui would not see.
#pragma once

#include "app/session/input.hpp"
#include "app/ui/imgui_headers.hpp"

#include <array>
#include <cstddef>

namespace meltpool::ui {

class Steering {
  public:
    /// False if Dear ImGui's Tab finds only fields of text.
    static constexpr bool kTabMoves = IMGUI_VERSION_NUM >= 18900;

    /// Shows the focus in the next frame: presses an arrow in a direction in which the focused window has no control,
    /// so that the focus stays, or comes to the window's first control.
    void show(ImGuiDir idle) { idle_ = idle; }
    /// Presses and releases the keys of this frame. Call before ImGui::NewFrame(). `steers`: keys move between the
    /// controls.
    void press(bool steers, const InputFrame& input);

  private:
    bool chooses(bool steers, const InputFrame& input);

    static constexpr size_t kKeyCount = 8;
    std::array<bool, kKeyCount> pressed_{};
    ImGuiDir idle_ = ImGuiDir_None;
    bool enterBefore_ = false; ///< the key or button that chooses was held in the last frame
    bool chooses_ = false;     ///< it was pressed on controls and is still held
};

} // namespace meltpool::ui
