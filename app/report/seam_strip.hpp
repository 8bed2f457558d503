// The seam drawn to scale with its imperfections, each with the letter that tables give it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meltpool {

/// One imperfection on the strip.
struct SeamMark {
    std::string letter;
    bool fails = false;                               ///< else it is not resolved or estimated
    double place = 0;                                 ///< mm along the seam where it is worst
    std::vector<std::pair<double, double>> stretches; ///< mm, from and to, where it fails
};

/// "A" .. "Z", "AA" .. of the number from 0 on.
std::string markLetter(size_t number);

/// Units of the strip's drawing, and where its seam begins and ends in it.
inline constexpr double kStripWidth = 640, kStripLeft = 20, kStripRight = 620;

/// The x in the drawing of a place on a seam from `from` to `to`, mm.
double stripX(double place, double from, double to);

/// An <svg> element: the seam from `from` to `to` (mm), stretches that fail in red with hatching, so that a grey print
/// shows them too, a mark with its letter at the worst places. Marks beyond the seam stand at its ends. Empty for a
/// seam without length.
std::string seamStrip(double from, double to, const std::vector<SeamMark>& marks);

} // namespace meltpool
