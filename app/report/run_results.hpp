// What a run has left in its folder, read for a report.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// A CSV file of numbers: cells that are empty or no number are NaN.
struct NumberTable {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows; ///< each as long as `columns`

    /// The values of a column; empty where there is none of this name.
    std::vector<double> column(std::string_view name) const;
};

/// Reads one. Throws InputError naming file and line for a row that is not as long as the head, and for a file that
/// cannot be read.
NumberTable readNumberTable(const std::filesystem::path& file);

struct RunResults {
    std::filesystem::path folder;
    nlohmann::json result;
    NumberTable technique; ///< empty where the lesson has none
    NumberTable weld;
    std::vector<std::filesystem::path> pictures; ///< of the last moment, in the order of their names
};

/// Reads result.json, technique.csv, weld.csv and the pictures' names of a run's folder. Throws InputError for a folder
/// without a finished run, and for files that are not what a run writes.
RunResults readRunResults(const std::filesystem::path& folder);

} // namespace meltpool
