// The page of an attempt: one HTML file that needs no other and loads nothing.
#pragma once

#include "app/report/run_results.hpp"

#include <string>

namespace meltpool {

/// Bytes as base64 (RFC 4648), with padding.
std::string base64(std::string_view bytes);

/// HTML 5: score and what to correct, the hand's curves with the lesson's bands, the verdict with its places on a strip
/// of the seam, the weld's figures, the arc and its heat input, and the pictures, which are part of the page. Lengths
/// in mm, or in inches by a switch that needs no script; printed on A4. Throws InputError where a picture cannot be
/// read.
std::string reportPage(const RunResults& results);

} // namespace meltpool
