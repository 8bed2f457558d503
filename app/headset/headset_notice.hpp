// Shows the notice in the headset: the window's warnings near the torch in view, and the scale of the workpiece.
#pragma once

#include "app/headset/headset_panel.hpp"
#include "app/session/lesson_figures.hpp"
#include "app/session/messages.hpp"
#include "xr/panel.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace meltpool {

/// Builds the notice's text in each frame without allocating.
class NoticeText {
  public:
    /// Lines up the newest warnings and what the desk did; below them the way to the work, the task (as many whole
    /// sentences as fit, only without a warning), the figure of slow metal unless a warning has it, the caption of
    /// sounds, and the zoom unless it is 1.
    void compose(const Messages& messages, const LessonFigures& figures, float zoom, std::string_view task = {},
                 std::span<const std::string_view> way = {});

    /// Whole text, one message a line.
    std::string_view text() const { return {text_.data(), length_}; }
    /// Part with the warnings; quiet() is the rest.
    std::string_view warnings() const { return text().substr(0, quietFrom_); }
    std::string_view quiet() const { return text().substr(quietFrom_); }

  private:
    void addLine(std::string_view line);

    std::array<char, 1280> text_{}; ///< room for three warnings, the task, the speed, a caption and the zoom
    size_t length_ = 0;
    size_t quietFrom_ = 0;
};

/// Sentence that leads the eyes to the work at this place of the workshop; empty if they look at it, to 35 degrees.
std::string_view wayToWork(const xr::Pose& head, const glm::vec3& work);
/// Returns true if the head is directed at a place, to 35 degrees.
bool faces(const xr::Pose& head, const glm::vec3& place);

/// Places the notice in the workshop: above the torch's end if the person looks there, else before their eyes; without
/// a warning or a caption on the table. It follows with a delay, so that a trembling hand does not blur it. Its width
/// is an angle, so that it covers no more of the view when the head comes near.
class NoticePlace {
  public:
    static constexpr float kAngle = 0.52f; ///< rad, its width in the view

    /// `atTorch`: the notice has a warning or a caption. `tip`: end of the torch, empty while none is seen. `panel`:
    /// the open panel, below which the notice hangs while the person looks there, at the side to which they look;
    /// empty: closed.
    void update(bool atTorch, const xr::Pose& head, const std::optional<glm::vec3>& tip, float tableHeight,
                double elapsed, const std::optional<xr::Pose>& panel = {});
    const xr::Pose& pose() const { return pose_; }
    /// Last seen end of the torch.
    const glm::vec3& end() const { return end_; }
    /// Width of the picture at that pose, m.
    float width() const { return width_; }

  private:
    xr::Pose pose_;
    float width_ = 0;
    glm::vec3 position_{0.0f};
    glm::vec3 end_{0.0f};
    bool known_ = false;
};

class HeadsetNotice {
  public:
    /// Shape of the picture; a text of three sentences fits. Its width in the view is NoticePlace's.
    static constexpr xr::PanelShape kShape{900, 560, 0.36f};
    /// Scale of the text: capital letters are a degree high at NoticePlace::kAngle.
    static constexpr float kTextScale = 2.45f;

    NoticeText text;
    NoticePlace place;

    /// Draws the text into the picture if it has changed, or if `opening` of the headset is a new one, whose picture is
    /// empty. `dimmed`: the person looks through a dark visor. Returns false if the picture is unchanged.
    bool draw(const xr::Panel& picture, int opening, bool dimmed, double elapsed);

  private:
    void drawText(ui::Context& context) const;

    std::unique_ptr<HeadsetPanel> panel_; ///< made at the first draw
    NoticeText drawn_;
    int opening_ = 0; ///< opening in which it was drawn
    bool dimmed_ = false;
};

} // namespace meltpool
