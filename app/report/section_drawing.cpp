#include "app/report/section_drawing.hpp"

#include "app/report/svg_text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cmath>

namespace meltpool {

namespace {

constexpr double kLargest = 16;  ///< units per millimetre
constexpr double kPicture = 176; ///< units of the width; the rest is for words
constexpr double kEdge = 8;      ///< units free around it
constexpr double kPlate = 4;     ///< mm of plate if its thickness is not known
constexpr double kBeside = 0.3;  ///< share of the weld's width: plate on each side of it
constexpr double kRow = 12;      ///< units from word to word

double plateOf(const SectionSizes& sizes) {
    return sizes.thickness.value_or(std::max(kPlate, sizes.penetration.value_or(0) * 1.2));
}

/// Size that the drawing has to hold, mm.
struct Extent {
    double width = 0, height = 0;
};

Extent extentOf(const SectionSizes& sizes) {
    if (sizes.fillet()) {
        const double base = *sizes.legBase * (1 + kBeside), upright = *sizes.legUpright * (1 + kBeside);
        return {base + plateOf(sizes), upright + plateOf(sizes)};
    }
    if (!sizes.height || !(sizes.toeWidth || sizes.fusedWidth)) return {};
    const double width = std::max(sizes.toeWidth.value_or(0), sizes.fusedWidth.value_or(0));
    return {width * (1 + 2 * kBeside), std::max(*sizes.height, 0.0) + plateOf(sizes)};
}

class Drawing {
  public:
    explicit Drawing(const SectionSizes& sizes)
        : sizes_(sizes),
          scale_(sectionScale(sizes)),
          svg_(kSectionWidth, kSectionHeight, phrase("drawing.section.label")) {}

    std::string element() {
        sizes_.fillet() ? fillet() : bead();
        words();
        scaleBar();
        return svg_.element();
    }

  private:
    std::string at(double x, double y) const {
        return SvgText::point(originX_ + x * scale_, originY_ - y * scale_) + " ";
    }
    std::string length(double mm) const { return SvgText::coordinate(mm * scale_); }

    void plate(double left, double bottom, double right, double top) {
        svg_.rectangle(originX_ + left * scale_, originY_ - top * scale_, originX_ + right * scale_,
                       originY_ - bottom * scale_, "plate");
    }

    /// Draws a bead; the origin is the middle of the face.
    void bead() {
        const Extent extent = extentOf(sizes_);
        originX_ = kEdge + extent.width / 2 * scale_;
        originY_ = kEdge + std::max(*sizes_.height, 0.0) * scale_;
        plate(-extent.width / 2, -plateOf(sizes_), extent.width / 2, 0);
        if (sizes_.fusedWidth && sizes_.penetration && *sizes_.fusedWidth > 0 && *sizes_.penetration > 0) {
            const double half = *sizes_.fusedWidth / 2;
            svg_.path("M" + at(-half, 0) + "A" + length(half) + " " + length(*sizes_.penetration) + " 0 0 0 " +
                          at(half, 0) + "Z",
                      "fused");
        }
        const double half = sizes_.toeWidth.value_or(sizes_.fusedWidth.value_or(0)) / 2;
        svg_.path("M" + at(-half, 0) + "Q" + at(0, 2 * *sizes_.height) + at(half, 0) + "Z", "weld");
    }

    /// Draws a fillet; the origin is the joint's corner, the base plate to the right.
    void fillet() {
        const double thick = plateOf(sizes_), base = *sizes_.legBase, upright = *sizes_.legUpright;
        originX_ = kEdge + thick * scale_;
        originY_ = kEdge + upright * (1 + kBeside) * scale_;
        plate(-thick, -thick, base * (1 + kBeside), 0);
        plate(-thick, 0, 0, upright * (1 + kBeside));
        fusedCorner(base, upright);
        // The face's middle is where the throat ends.
        const double chord = std::hypot(base, upright);
        const double out = chord > 0 ? sizes_.throat.value_or(base * upright / chord) - base * upright / chord : 0;
        const double x = base / 2 + 2 * out * upright / std::max(chord, 1e-9);
        const double y = upright / 2 + 2 * out * base / std::max(chord, 1e-9);
        svg_.path("M" + at(0, 0) + "L" + at(base, 0) + "Q" + at(x, y) + at(0, upright) + "Z", "weld");
    }

    /// Draws the fusion of both plates, as deep as the deepest measurement, over the fused share of the faces.
    void fusedCorner(double base, double upright) {
        const double depth = sizes_.penetration.value_or(0);
        const double share = std::min(1.0, sizes_.fusedWidth.value_or(0) / std::max(base + upright, 1e-9));
        if (!(depth > 0) || !(share > 0)) return;
        const double right = base * share, top = upright * share;
        svg_.path("M" + at(0, 0) + "L" + at(right, 0) + "Q" + at(right / 2, -2 * depth) + at(0, 0) + "Q" +
                      at(-2 * depth, top / 2) + at(0, top) + "Z",
                  "fused");
    }

    void word(std::string_view size, const std::optional<double>& mm) {
        if (!mm) return;
        const double y = kEdge + kRow * ++rows_;
        const std::string key = "drawing.section." + std::string(size);
        const auto sized = [&](const PhraseNumber& number, std::string_view unit) {
            const std::string length = std::string(number).append(" ").append(unit);
            svg_.word(kPicture + 12, y, "start", phrase(key, {{"length", length}}), unit);
        };
        sized(PhraseNumber(*mm, 1), "mm");
        sized(PhraseNumber(*mm * inchUnit("mm").perMetric, 3), "in");
    }

    void part(int row, std::string_view style) {
        const double y = kSectionHeight - 28 + row * kRow;
        svg_.rectangle(kPicture + 12, y, kPicture + 21, y + 9, style);
        svg_.word(kPicture + 25, y + 8, "start", phraseOf("drawing.section.part", style));
    }

    void words() {
        if (sizes_.fillet()) {
            word("leg_base", sizes_.legBase);
            word("leg_upright", sizes_.legUpright);
            word("throat", sizes_.throat);
        } else {
            word("width", sizes_.toeWidth);
            word("height", sizes_.height);
        }
        word("penetration", sizes_.penetration);
        word("fused_width", sizes_.fusedWidth);
        word("plate", sizes_.thickness);
        part(0, "weld");
        part(1, "fused");
    }

    void scaleBar() {
        const double y = kSectionHeight - 3;
        svg_.line(kEdge, y, kEdge + 5 * scale_, y, "axis mm");
        svg_.word(kEdge + 5 * scale_ + 4, y, "start", "5 mm", "mm");
        const double quarter = 0.25 / inchUnit("mm").perMetric;
        svg_.line(kEdge, y, kEdge + quarter * scale_, y, "axis in");
        svg_.word(kEdge + quarter * scale_ + 4, y, "start", std::string(PhraseNumber(0.25, 2)) + " in", "in");
    }

    const SectionSizes& sizes_;
    double scale_;
    SvgText svg_;
    double originX_ = 0, originY_ = 0;
    int rows_ = 0;
};

} // namespace

double sectionScale(const SectionSizes& sizes) {
    const Extent extent = extentOf(sizes);
    if (!(extent.width > 0) || !(extent.height > 0)) return 0;
    constexpr double kBar = 12; // units for the scale's bar
    return std::min(
        {(kPicture - 2 * kEdge) / extent.width, (kSectionHeight - 2 * kEdge - kBar) / extent.height, kLargest});
}

std::string sectionDrawing(const SectionSizes& sizes) {
    return sectionScale(sizes) > 0 ? Drawing(sizes).element() : std::string();
}

} // namespace meltpool
