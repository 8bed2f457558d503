// The parts of the page of an attempt, each as HTML, empty if the attempt has no data for it.
#pragma once

#include "app/report/run_results.hpp"

#include <string>

namespace meltpool {

/// Lesson, how and when the attempt was made, with which program, driver and help, and the missing parts.
std::string headPart(const RunResults& results);
/// Score, and the first corrections.
std::string scorePart(const RunResults& results);
/// Weld from outside and cut: pictures of the run's last moment, or the section drawn from the measured sizes.
std::string picturePart(const RunResults& results);
/// Quantities of the hand: points, mean, target.
std::string techniquePart(const RunResults& results);
/// Curves along the seam: the judged quantities with their bands, the arc's current and voltage.
std::string curvePart(const RunResults& results);
/// Verdict by imperfection, with a strip of the seam.
std::string verdictPart(const RunResults& results);
/// Measured weld and the arc in figures, with the heat input by EN 1011-1.
std::string figurePart(const RunResults& results);

} // namespace meltpool
