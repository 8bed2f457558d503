// Whether the file of a record is whole, however its program ended.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool::test {

struct RecordCheck {
    std::vector<std::string> broken; ///< lines that are neither a comment nor a row of the header's cells, numbered
    size_t rows = 0;
    double lastTime = 0;    ///< s, of the metal in the last row
    bool endsWhole = false; ///< the last line has its end
    std::string ended;      ///< what `# ended` says; empty: nothing

    bool whole() const { return broken.empty() && endsWhole; }
};

/// Throws InputError where the file cannot be read.
RecordCheck checkRecord(const std::filesystem::path& file);

} // namespace meltpool::test
