#include "app/desktop/picture_quality.hpp"

#include "core/base/words.hpp"

#include <algorithm>

namespace meltpool {

namespace {

// none: the numbers below are chosen so that a level changes at most every few seconds in a steady weld.
constexpr int kFewestFrames = 4;       ///< before a level is judged: the first frames include the cost of the change
constexpr double kSmooth = 0.2;        ///< weight of the newest frame
constexpr double kTooMuch = 1.1;       ///< factor on the allowed time: above it, coarser
constexpr double kSurelyEnough = 0.85; ///< factor on the allowed time: below it, finer
constexpr double kFirstPatience = 2;   ///< s
constexpr double kMostPatience = 60;   ///< s
constexpr double kStill = 0.5;         ///< s without movement, after which metal and picture count as still
constexpr double kForgotten = 20;      ///< s after which the cost of another level is a guess again
/// Share of a frame's work apart from steps that does not grow with the picture's pixels, while only one level is
/// known.
constexpr double kFixed = 0.3;

double area(int level) {
    const double share = static_cast<double>(kPictureShares[static_cast<size_t>(level)]);
    return share * share;
}

} // namespace

std::span<const std::string_view> pictureChoices() {
    static constexpr std::array<std::string_view, kPictureLevels + 1> kChoices{"automatic", "full", "fine", "medium",
                                                                               "coarse"};
    return kChoices;
}

std::string_view pictureSentence(PictureLevel level) {
    static constexpr std::array<std::string_view, kPictureLevels> kKeys{"", "desk.picture.fine", "desk.picture.medium",
                                                                        "desk.picture.coarse"};
    const std::string_view key = kKeys[static_cast<size_t>(level)];
    return key.empty() ? key : phrase(key);
}

void PictureBudget::restart() {
    *this = {};
}

/// Steps that are slower than the clock take all the time they can get and make frames long. A picture with a small
/// share of such a frame keeps its level: fewer pixels would save next to nothing. A picture that runs in parallel with
/// steps costs nothing if it ends before they do.
double PictureBudget::allowed(double rest) const {
    const double frame = frame_ - known_[static_cast<size_t>(level_)].rest + rest;
    return std::max({kFrame * (1 - load_), kLeastShare * std::max(kFrame, frame), least_});
}

bool PictureBudget::fits(double rest, double share) const {
    return rest <= share * allowed(rest);
}

double PictureBudget::expectedAt(int level) const {
    const Known& there = known_[static_cast<size_t>(level)];
    const Known& here = known_[static_cast<size_t>(level_)];
    if (there.rest > 0 && there.age < kForgotten) return there.rest;
    return here.rest * (kFixed + (1 - kFixed) * area(level) / area(level_));
}

void PictureBudget::moveTo(int level) {
    const bool up = level < level_;
    // A quick return to the coarser level makes the next trial of the finer one later.
    if (!up && wentUp_) patience_ = std::min(2 * patience_, kMostPatience);
    if (up && !wentUp_ && here_ > 2 * patience_) patience_ = kFirstPatience;
    wentUp_ = up;
    level_ = level;
    frames_ = 0;
    here_ = 0;
    frame_ = 0;
}

void PictureBudget::add(const FrameCost& frame) {
    for (Known& each : known_)
        each.age += frame.seconds;
    here_ += frame.seconds;
    load_ += (frame.load - load_) * kSmooth;
    least_ += (frame.least - least_) * kSmooth;
    if (++frames_ <= 1) return; // the first frame still has the picture of the level before
    Known& known = known_[static_cast<size_t>(level_)];
    const double rest = std::max(frame.seconds - frame.steps, 1e-6);
    known.rest = frames_ == 2 || known.rest == 0 ? rest : known.rest + (rest - known.rest) * kSmooth;
    known.age = 0;
    frame_ = frame_ == 0 ? frame.seconds : frame_ + (frame.seconds - frame_) * kSmooth;
    if (frames_ < kFewestFrames) return;
    if (!fits(known.rest, kTooMuch) && frame_ > kFrame) {
        int coarser = level_;
        while (coarser + 1 < static_cast<int>(kPictureLevels) && !fits(expectedAt(coarser), kTooMuch))
            ++coarser;
        if (coarser != level_) moveTo(coarser);
        return;
    }
    if (level_ > 0 && here_ > patience_ && fits(expectedAt(level_ - 1), kSurelyEnough)) moveTo(level_ - 1);
}

bool StillPicture::count(double seconds, bool moves) {
    const double before = metal_;
    metal_ = moves ? 0 : metal_ + seconds;
    picture_ = moves ? 0 : picture_ + seconds;
    return before < kStill && metal_ >= kStill;
}

bool StillPicture::stands(const View& view) {
    if (view.worldToEye != seen_.worldToEye || view.eyeToClip != seen_.eyeToClip) picture_ = 0;
    seen_ = view;
    return picture_ >= kStill;
}

} // namespace meltpool
