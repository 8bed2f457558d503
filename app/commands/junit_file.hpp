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
    std::vector<std::string> warnings; ///< of the lesson and its torch path; they do not fail it
    std::string error;                 ///< why the check could not be run to its end; empty where it was
    double wallSeconds = 0;            ///< that it took

    bool passed() const;
    /// What did not come out as expected, a sentence for each; empty where it passed.
    std::vector<std::string> faults() const;
};

/// One test suite `meltpool check` with a test case for each outcome. Throws what writeTextFileAtomically() throws.
void writeJunitFile(const std::filesystem::path& file, const std::vector<CheckOutcome>& outcomes);

} // namespace meltpool
