// The parts of the page of an attempt, each as HTML, empty where the attempt has nothing of it.
#pragma once

#include "app/report/run_results.hpp"

#include <string>

namespace meltpool {

/// Lesson, how and when the attempt was made, with which program, driver and help, and what is missing.
std::string headPart(const RunResults& results);
/// Score, and what to correct first.
std::string scorePart(const RunResults& results);
/// The weld from outside and cut: pictures of the run's last moment, or the section drawn from what was measured.
std::string picturePart(const RunResults& results);
/// Each quantity of the hand: points, mean, what was asked for.
std::string techniquePart(const RunResults& results);
/// The curves along the seam: the judged quantities with their bands, the arc's current and voltage.
std::string curvePart(const RunResults& results);
/// The verdict by imperfection, with a strip of the seam.
std::string verdictPart(const RunResults& results);
/// The measured weld and the arc in figures, with the heat input by EN 1011-1.
std::string figurePart(const RunResults& results);

} // namespace meltpool
