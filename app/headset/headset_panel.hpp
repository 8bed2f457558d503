// A Dear ImGui context of its own for the panel in the headset, used with a pointer.
#pragma once

#include "app/ui/panels.hpp"
#include "core/base/function_ref.hpp"

#include <glm/vec2.hpp>

#include <optional>

struct ImGuiContext;

namespace meltpool {

/// What the pointer does on the panel in this frame.
struct PointerOnPanel {
    std::optional<glm::vec2> place; ///< pixels from the top left corner; nothing: it points elsewhere
    bool pressed = false;
    float scroll = 0; ///< lines, up is positive
};

class HeadsetPanel {
  public:
    /// What lies behind the content.
    enum class Ground { dark, clear };

    HeadsetPanel(int width, int height, Ground ground = Ground::dark);
    ~HeadsetPanel();
    HeadsetPanel(const HeadsetPanel&) = delete;
    HeadsetPanel& operator=(const HeadsetPanel&) = delete;

    /// Draws what `content` puts into one window that fills the panel, into `framebuffer`. Dear ImGui's current context
    /// is the window's again afterwards.
    void draw(GLuint framebuffer, const PointerOnPanel& pointer, double elapsed,
              FunctionRef<void(ui::Context&)> content);
    /// Where the controls are, in the panel's pixels.
    const ui::Context& context() const { return context_; }

  private:
    int width_;
    int height_;
    Ground ground_;
    ImGuiContext* imgui_ = nullptr;
    ui::Context context_;
};

} // namespace meltpool
