#include "app/report/seam_strip.hpp"

#include "app/report/curve_scale.hpp"
#include "app/report/svg_text.hpp"
#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kTop = 34, kBottom = 46, kHeight = 72;
constexpr double kLetterRow = 10; ///< between two rows of letters
constexpr double kClose = 12;     ///< letters closer than this are placed in rows

class Strip {
  public:
    Strip(double from, double to) : from_(from), to_(to), svg_(kStripWidth, kHeight, phrase("drawing.seam.label")) {}

    std::string element(const std::vector<SeamMark>& marks) {
        svg_.rectangle(kStripLeft, kTop, kStripRight, kBottom, "seam");
        for (const SeamMark& mark : marks)
            for (const auto& [low, high] : mark.stretches)
                stretch(low, high);
        std::vector<SeamMark> inOrder = marks;
        std::stable_sort(inOrder.begin(), inOrder.end(),
                         [](const SeamMark& a, const SeamMark& b) { return a.place < b.place; });
        for (const SeamMark& mark : inOrder)
            letter(mark);
        axis(1, "mm", " mm");
        axis(inchUnit("mm").perMetric, "in", " in");
        return svg_.element();
    }

  private:
    double x(double place) const { return stripX(place, from_, to_); }

    /// Draws a stretch in red, hatched for printers without colour.
    void stretch(double low, double high) {
        const double left = x(low), right = x(high);
        svg_.rectangle(left, kTop, right, kBottom, "fault");
        constexpr double kStep = 5;
        for (double at = left; at + kStep <= right + 0.1; at += kStep)
            svg_.line(at, kBottom, at + kStep, kTop, "hatch");
    }

    void letter(const SeamMark& mark) {
        const double at = x(mark.place);
        row_ = at - last_ < kClose ? (row_ + 1) % 3 : 0;
        last_ = at;
        const double y = kTop - 5 - row_ * kLetterRow;
        svg_.line(at, y + 1, at, kBottom + 3, mark.fails ? "mark-fail" : "mark-other");
        svg_.word(at, y, "middle", mark.letter, mark.fails ? "letter-fail" : "");
    }

    void axis(double scale, std::string_view system, std::string_view unit) {
        const CurveTicks ticks = curveTicks({from_ * scale, to_ * scale}, 8);
        for (int k = 0; k < ticks.count; ++k) {
            const double at = x(ticks.at(k) / scale), value = std::abs(ticks.at(k)) < 1e-9 ? 0 : ticks.at(k);
            svg_.line(at, kBottom + 4, at, kBottom + 8, "axis " + std::string(system));
            svg_.word(at, kBottom + 18, "middle",
                      withDecimalMark(formatNumber(static_cast<float>(value))) + std::string(unit), system);
        }
    }

    double from_, to_;
    SvgText svg_;
    double last_ = -kStripWidth; ///< x of the letter before
    int row_ = 0;                ///< row of the letter before
};

} // namespace

std::string markLetter(size_t number) {
    const std::string last(1, static_cast<char>('A' + number % 26));
    return number < 26 ? last : markLetter(number / 26 - 1) + last;
}

double stripX(double place, double from, double to) {
    return kStripLeft + std::clamp((place - from) / (to - from), 0.0, 1.0) * (kStripRight - kStripLeft);
}

std::string seamStrip(double from, double to, const std::vector<SeamMark>& marks) {
    if (!(to > from)) return {};
    return Strip(from, to).element(marks);
}

} // namespace meltpool
