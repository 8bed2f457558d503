// Results of checks as a JUnit file, which build servers and school systems read.
#pragma once

#include "core/training/lesson/lesson_check.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

struct CheckOutcome {
    std::string name;
    std::filesystem::path file;
    std::vector<CheckedValue> values;
    std::vector<std::string> warnings; ///< warnings of the lesson and its torch path; they do not fail it
    std::string error;                 ///< reason why the check could not run to its end; empty if it did
    double wallSeconds = 0;            ///< s that it took

    bool passed() const;
    /// Differences from the expected result, a sentence for each; empty if it passed.
    std::vector<std::string> faults() const;
};

/// Writes one test suite `meltpool check` with a test case for each outcome. Throws whatever writeTextFileAtomically()
/// throws.
void writeJunitFile(const std::filesystem::path& file, const std::vector<CheckOutcome>& outcomes);

} // namespace meltpool
