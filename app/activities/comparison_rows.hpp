// Two attempts side by side in a welder's words: the content of the comparison panel, without drawing it.
#pragma once

#include "core/training/attempt/differences.hpp"
#include "core/training/judging/judgement.hpp"

#include <string>
#include <vector>

namespace meltpool {

struct ComparedRow {
    std::string name;
    std::string first, second; ///< values with units; "-" if one has none
    std::string difference;    ///< second less first; empty: none that counts
};

struct ComparedSection {
    const char* name = ""; ///< one name for every language
    std::string title;
    std::vector<ComparedRow> rows;
};

struct ComparisonRows {
    std::string words;              ///< sentence: "The second: 0.4 mm more penetration, 12 points more."
    std::vector<std::string> notes; ///< sentences in small print
    std::vector<ComparedSection> sections;
};

/// Rows of two judgements. `comparison`: of the two, see compareAttempts().
ComparisonRows comparisonRows(const Judgement& first, const Judgement& second, const Comparison& comparison);

} // namespace meltpool
