// The seam drawn to scale with its imperfections, each with its letter from the tables.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meltpool {

/// Imperfection on the strip.
struct SeamMark {
    std::string letter;
    bool fails = false;                               ///< false: it is not resolved or estimated
    double place = 0;                                 ///< mm along the seam, at its worst
    std::vector<std::pair<double, double>> stretches; ///< mm, from and to, of the failing stretches
};

/// Letter "A" .. "Z", "AA" .. of a number from 0 on.
std::string markLetter(size_t number);

/// Size of the strip's drawing, and the ends of its seam in it.
inline constexpr double kStripWidth = 640, kStripLeft = 20, kStripRight = 620;

/// Coordinate x in the drawing for a place on a seam from `from` to `to`, mm.
double stripX(double place, double from, double to);

/// <svg> element: the seam from `from` to `to` (mm), failing stretches in red with hatching, so that a grey print shows
/// them too, a mark with its letter at the worst places. Marks beyond the seam are drawn at its ends. Empty for a seam
/// without length.
std::string seamStrip(double from, double to, const std::vector<SeamMark>& marks);

} // namespace meltpool
