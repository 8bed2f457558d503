// Chooses how finely the window draws the metal's picture: the levels, and the choice by the time that the metal's
// steps leave of a frame.
#pragma once

#include "core/render/view.hpp"

#include <array>
#include <span>
#include <string_view>

namespace meltpool {

/// Level by share of the picture's width and height in the window's pixels. Text and menus are always drawn with all
/// pixels.
enum class PictureLevel : int { full, fine, medium, coarse };
constexpr size_t kPictureLevels = 4;

/// Share of the window's width and height at each level. none: chosen; a pool of `gmaw-bead` is some forty pixels long
/// at the coarsest in a window of 1280x720.
constexpr std::array<float, kPictureLevels> kPictureShares{1.0f, 0.75f, 0.5f, 0.375f};

/// Choices of the setting: automatic, then the levels.
std::span<const std::string_view> pictureChoices();

/// Name of a level for people: "picture at 1/2"; empty for the full one.
std::string_view pictureSentence(PictureLevel level);

/// Costs of a frame that the budget counts.
struct FrameCost {
    double seconds = 0; ///< s from the frame's begin to the next frame's
    double steps = 0;   ///< share of it for steps of the metal, s
    double load = 0;    ///< frame time for the steps of one second of the metal, s; 0: none
    /// Time of the frame without a picture, if steps run while it is drawn, s; see StepClock::busyBeside().
    double least = 0;
};

/// Chooses the finest level at which frames leave the metal its time: the work apart from steps may take its share of
/// kFrame. Nothing here reads a clock of its own or waits for the graphics driver.
class PictureBudget {
  public:
    static constexpr double kFrame = 0.045;     ///< s; none: chosen, a little more than twenty pictures a second
    static constexpr double kLeastShare = 0.25; ///< smallest share of a frame for the picture, on machines however slow

    /// Counts a frame that was drawn at level().
    void add(const FrameCost& frame);
    PictureLevel level() const { return static_cast<PictureLevel>(level_); }
    /// Forgets the cost of pictures: call for another lesson or another size of the window.
    void restart();

  private:
    /// Allowed time of a frame's work apart from steps, s, if that work takes `rest` now.
    double allowed(double rest) const;
    /// Returns true if `rest` is at most `share` of the allowed time.
    bool fits(double rest, double share) const;
    double expectedAt(int level) const;
    void moveTo(int level);

    struct Known {
        double rest = 0; ///< s of a frame apart from steps; 0: unknown
        double age = 0;  ///< s since it was measured
    };
    std::array<Known, kPictureLevels> known_{};
    double load_ = 0;
    double frame_ = 0; ///< s
    double least_ = 0; ///< s
    int level_ = 0;
    int frames_ = 0;      ///< frames at this level
    double here_ = 0;     ///< s at this level
    double patience_ = 2; ///< s at a level before a trial of a finer one
    bool wentUp_ = false; ///< the last change was to a finer level
};

/// Recognises a picture in which nothing moves: it may take its time and is drawn with all pixels.
class StillPicture {
  public:
    /// Counts the last frame; `moves`: the metal moved, or a seek changed the picture. Returns true if the metal has
    /// just come to rest: the cost of pictures next to its steps means little then.
    bool count(double seconds, bool moves);
    /// Returns true if neither metal nor camera moved lately. Call once a frame with the camera's view.
    bool stands(const View& view);

  private:
    double metal_ = 0;   ///< s since the metal moved
    double picture_ = 0; ///< s since metal or camera moved
    View seen_;          ///< view of the last frame
};

} // namespace meltpool
