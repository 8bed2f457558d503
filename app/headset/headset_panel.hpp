// Draws the panel in the headset in a Dear ImGui context of its own, used with a pointer.
#pragma once

#include "app/ui/panels.hpp"
#include "core/base/function_ref.hpp"

#include <glm/vec2.hpp>

#include <optional>

struct ImGuiContext;

namespace meltpool {

/// State of the pointer on the panel in this frame.
struct PointerOnPanel {
    std::optional<glm::vec2> place; ///< pixels from the top left corner; empty: it points elsewhere
    bool pressed = false;
    float scroll = 0; ///< lines, up is positive
};

class HeadsetPanel {
  public:
    /// Background behind the content.
    enum class Ground { dark, clear };

    /// Scale of text that is readable at arm's length.
    static constexpr float kScale = 2.2f;

    HeadsetPanel(int width, int height, Ground ground = Ground::dark, float scale = kScale);
    ~HeadsetPanel();
    HeadsetPanel(const HeadsetPanel&) = delete;
    HeadsetPanel& operator=(const HeadsetPanel&) = delete;

    /// Draws `content` as one window that fills the panel, into `framebuffer`. Makes the window's Dear ImGui context
    /// current again afterwards.
    void draw(GLuint framebuffer, const PointerOnPanel& pointer, double elapsed,
              FunctionRef<void(ui::Context&)> content);
    /// Context with the places of the controls, in the panel's pixels.
    const ui::Context& context() const { return context_; }

  private:
    int width_;
    int height_;
    Ground ground_;
    ImGuiContext* imgui_ = nullptr;
    ui::Context context_;
};

} // namespace meltpool
