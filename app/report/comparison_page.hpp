// The page of two attempts side by side: one HTML file that needs no other and loads nothing.
#pragma once

#include "app/report/compared_run.hpp"

#include <string>

namespace meltpool {

/// HTML 5: the difference in words, points of each quantity side by side, every figure of both with its difference,
/// their pictures of one look, curves of weld and hand over each other. Differences below the metal's resolution are
/// shown, but not as differences. Lengths in mm, or in inches by a switch that needs no script; printed on A4. Throws
/// InputError if a picture cannot be read.
std::string comparisonPage(const ComparedRun& first, const ComparedRun& second);

} // namespace meltpool
