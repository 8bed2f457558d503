// The notice in the headset: the window's warnings where the person looks, beside the torch, and how large the
// workpiece is shown.
#pragma once

#include "app/headset/headset_panel.hpp"
#include "app/session/lesson_figures.hpp"
#include "app/session/messages.hpp"
#include "xr/panel.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string_view>

namespace meltpool {

/// The notice's text, built in each frame without allocating.
class NoticeText {
  public:
    /// The newest warnings, then that the metal is slow, then what is heard, then the zoom where it is not 1.
    void compose(const Messages& messages, const LessonFigures& figures, float zoom);

    /// All of it, a line each.
    std::string_view text() const { return {text_.data(), length_}; }
    /// The part that warns, and what is heard with the zoom's line.
    std::string_view warnings() const { return text().substr(0, quietFrom_); }
    std::string_view quiet() const { return text().substr(quietFrom_); }

  private:
    void addLine(std::string_view line);

    std::array<char, 1280> text_{}; ///< three warnings, the speed and the zoom fit
    size_t length_ = 0;
    size_t quietFrom_ = 0;
};

/// Where the notice hangs, in the workshop: above the torch's tip where the person looks there, else before their eyes;
/// without a warning it lies on the table. It follows with a delay, so that a trembling hand does not blur it.
class NoticePlace {
  public:
    void update(bool warns, const xr::Pose& head, const std::optional<glm::vec3>& tip, float tableHeight,
                double elapsed);
    const xr::Pose& pose() const { return pose_; }

  private:
    xr::Pose pose_;
    glm::vec3 position_{0.0f};
    bool known_ = false;
};

class HeadsetNotice {
  public:
    /// Shape of the picture; a text of three sentences fits.
    static constexpr xr::PanelShape kShape{900, 400, 0.36f};

    NoticeText text;
    NoticePlace place;

    /// Draws the text into the picture where it has changed, or where `opening` of the headset is another one, whose
    /// picture is empty. False: the picture is as it was.
    bool draw(const xr::Panel& picture, int opening, double elapsed);

  private:
    void drawText(ui::Context& context) const;

    std::unique_ptr<HeadsetPanel> panel_; ///< made when it is first drawn
    NoticeText drawn_;
    int opening_ = 0; ///< in which it was drawn
};

} // namespace meltpool
