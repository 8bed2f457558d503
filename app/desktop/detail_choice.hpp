// Chooses how much of light and metal the pictures of a lesson compute: by the setting, or automatically for this
// machine.
#pragma once

#include "core/gl/profiler.hpp"
#include "core/render/look/look.hpp"

#include <span>
#include <string_view>

namespace meltpool {

/// Choices of the setting: automatic, then the levels from the lowest on.
std::span<const std::string_view> detailChoices();

/// Name of a level for people: "low detail"; empty for the highest.
std::string_view detailSentence(PictureDetail level);

/// Finds the level with which a picture takes its share of a frame. A driver that draws on the processor gets the
/// lowest; on a card the first pictures of a lesson are measured, from the highest level down. Reads no clock.
class DetailTrial {
  public:
    /// Share of the time that the display gives a picture; the metal's steps need the card too. None: chosen.
    static constexpr double kShare = 0.4;

    explicit DetailTrial(bool software) : software_(software) { restart(); }

    PictureDetail level() const { return level_; }
    bool settled() const { return settled_; }
    /// Counts a picture that was drawn at level() and took the card `picture` s, on a display that waits `frame` s.
    void add(double picture, double frame);
    /// Restarts the trial for another lesson or another display.
    void restart();

  private:
    bool software_;
    PictureDetail level_ = kHighDetail;
    bool settled_ = false;
    int pictures_ = 0; ///< counted at this level
    double least_ = 0; ///< s of the quickest counted picture
};

/// Sets the level of the next pictures by setting or trial, and measures the card's time for the trial.
class DetailChoice {
  public:
    static constexpr double kWindowFrame = 1.0 / 60;  ///< s
    static constexpr double kHeadsetFrame = 1.0 / 90; ///< s

    explicit DetailChoice(bool software) : trial_(software) {}

    /// `setting`: index into detailChoices(). `running`: there is a lesson; `headset`: the headset shows it.
    void update(int setting, bool running, bool headset);
    PictureDetail level() const;

    /// Draws a picture by `draw`, measured if the trial needs that. Nothing waits for the card.
    template <typename Draw>
    void draw(const Draw& draw) {
        if (setting_ != 0 || trial_.settled()) return draw();
        timer_.beginFrame();
        {
            const gl::Scope scope(&timer_, "picture");
            draw();
        }
        timer_.endFrame();
        count();
    }

  private:
    void count();

    DetailTrial trial_;
    gl::Profiler timer_;
    int seen_ = 0; ///< pictures read from the timer
    int setting_ = 0;
    bool headset_ = false;
};

} // namespace meltpool
