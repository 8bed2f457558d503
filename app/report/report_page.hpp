// The page of an attempt: one HTML file that needs no other and loads nothing.
#pragma once

#include "app/report/page_text.hpp"
#include "app/report/run_results.hpp"

#include <string>

namespace meltpool {

/// HTML 5: the head, score and corrections, pictures or the drawn section, the hand's curves with the lesson's bands,
/// the verdict with its places on a strip of the seam, the weld's figures, the arc and its heat input. Pictures are
/// part of the page. Lengths in mm, or in inches by a switch that needs no script; two sides of A4 in print. Missing
/// parts are named.
std::string reportPage(const RunResults& results);

} // namespace meltpool
