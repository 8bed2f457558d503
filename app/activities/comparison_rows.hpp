// Two attempts beside each other in a welder's words: what the panel of both shows, without drawing it.
#pragma once

#include "core/training/attempt/differences.hpp"
#include "core/training/judging/judgement.hpp"

#include <string>
#include <vector>

namespace meltpool {

struct ComparedRow {
    std::string name;
    std::string first, second; ///< with units; "-" where one has none
    std::string difference;    ///< second less first; empty: none that counts
};

struct ComparedSection {
    const char* name = ""; ///< in every language
    std::string title;
    std::vector<ComparedRow> rows;
};

struct ComparisonRows {
    std::string words;              ///< "The second: 0.4 mm more penetration, 12 points more."
    std::vector<std::string> notes; ///< sentences in small print
    std::vector<ComparedSection> sections;
};

/// `comparison`: of the two, see compareAttempts().
ComparisonRows comparisonRows(const Judgement& first, const Judgement& second, const Comparison& comparison);

} // namespace meltpool
