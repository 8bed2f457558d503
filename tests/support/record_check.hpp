// Checks if the file of a record is complete, however its program ended.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool::test {

struct RecordCheck {
    std::vector<std::string> broken; ///< numbered lines that are neither a comment nor a row of the header's cells
    size_t rows = 0;
    double lastTime = 0;    ///< metal's time in the last row, s
    bool endsWhole = false; ///< the last line has its end
    std::string ended;      ///< reason in the line `# ended`; empty: none

    bool whole() const { return broken.empty() && endsWhole; }
};

/// Throws InputError if the file cannot be read.
RecordCheck checkRecord(const std::filesystem::path& file);

} // namespace meltpool::test
