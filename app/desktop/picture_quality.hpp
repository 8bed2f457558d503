// How finely the window draws the metal's picture: the levels there are, and the choice among them by what the metal's
// steps leave of a frame's time.
#pragma once

#include "core/render/view.hpp"

#include <array>
#include <span>
#include <string_view>

namespace meltpool {

/// Of the picture's width and height in the window's pixels. Text and menus are always drawn with all pixels.
enum class PictureLevel : int { full, fine, medium, coarse };
constexpr size_t kPictureLevels = 4;

/// Share of the window's width and height that a level is drawn with. none: chosen; a pool of `gmaw-bead` is some forty
/// pixels long at the coarsest in a window of 1280x720.
constexpr std::array<float, kPictureLevels> kPictureShares{1.0f, 0.75f, 0.5f, 0.375f};

/// Choices of the setting: automatic, then the levels.
std::span<const std::string_view> pictureChoices();

/// What a person reads of a level: "picture at 1/2"; empty for the full one.
std::string_view pictureSentence(PictureLevel level);

/// A frame as the budget sees it.
struct FrameCost {
    double seconds = 0; ///< from the frame's begin to the next one's
    double steps = 0;   ///< s of it that went into steps of the metal
    double load = 0;    ///< s of the frames that the steps of a second of the metal take; 0: they take none
    double least = 0;   ///< s that the frame would take without a picture, where steps are made beside that; see
                        ///< StepClock::busyBeside()
};

/// Chooses the finest level with which frames leave the metal its time: what a frame does besides steps may take its
/// share of kFrame. Nothing here reads a clock of its own or waits for the graphics driver.
class PictureBudget {
  public:
    static constexpr double kFrame = 0.045;     ///< s; none: chosen, a little more than twenty pictures a second
    static constexpr double kLeastShare = 0.25; ///< of a frame, for the picture on machines however slow

    /// Counts a frame that was drawn at level().
    void add(const FrameCost& frame);
    PictureLevel level() const { return static_cast<PictureLevel>(level_); }
    /// Forgets what pictures cost: another lesson, another size of the window.
    void restart();

  private:
    /// s that a frame may spend on what is not steps, where that takes `rest`.
    double allowed(double rest) const;
    /// Whether `rest` is at most `share` of what is allowed.
    bool fits(double rest, double share) const;
    double expectedAt(int level) const;
    void moveTo(int level);

    struct Known {
        double rest = 0; ///< s of a frame besides steps; 0: not known
        double age = 0;  ///< s since it was seen
    };
    std::array<Known, kPictureLevels> known_{};
    double load_ = 0;
    double frame_ = 0; ///< s
    double least_ = 0; ///< s
    int level_ = 0;
    int frames_ = 0;      ///< at this level
    double here_ = 0;     ///< s at this level
    double patience_ = 2; ///< s at a level before a finer one is tried
    bool wentUp_ = false; ///< the last change was to a finer level
};

/// Knows a picture in which nothing moves: it has no hurry and is drawn with all pixels.
class StillPicture {
  public:
    /// Counts the last frame; `moves`: the metal did, or what is shown of it was sought. True where the metal has just
    /// come to stand: what pictures cost beside its steps says little then.
    bool count(double seconds, bool moves);
    /// To be asked once a frame, with what it looks from.
    bool stands(const View& view);

  private:
    double metal_ = 0;   ///< s since the metal moved
    double picture_ = 0; ///< s since it or the camera did
    View seen_;          ///< in the last frame
};

} // namespace meltpool
