// The files of a run's folder, read for a report.
#pragma once

#include "core/training/judging/judgement.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// CSV file of numbers: cells that are empty or no number are NaN.
struct NumberTable {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows; ///< each as long as `columns`

    /// Values of a column; empty if there is none of this name.
    std::vector<double> column(std::string_view name) const;
};

/// Reads a table from its text; `file` is named in faults. Throws as readNumberTable().
NumberTable numberTable(const std::string& text, const std::filesystem::path& file);

/// Reads a table. Throws InputError naming file and line for a row whose length differs from the header's, for faults
/// that TableReader refuses, and for a file that cannot be read.
NumberTable readNumberTable(const std::filesystem::path& file);

/// Picture of the weld, as part of a page.
struct ReportPicture {
    std::string name; ///< name of the lesson's picture, such as "metal" or "section"
    std::string png;  ///< bytes of the file
};

/// Data of an attempt. All of it is read, nothing computed.
struct RunResults {
    nlohmann::json result; ///< result.json
    NumberTable technique; ///< technique.csv; empty if the lesson has none
    NumberTable weld;      ///< weld.csv
    std::vector<ReportPicture> pictures;
    std::vector<std::string> notes; ///< sentences for the reader, such as that parts are missing
};

/// Results of an attempt that was judged just now, as if its run's folder had been read: `entries` of its result.json,
/// technique and weld from the judgement. Without pictures.
RunResults resultsOf(const nlohmann::ordered_json& entries, const Judgement& judgement);

/// Reads result.json, technique.csv, weld.csv and the pictures of the last moment of a run's folder. `place`: the
/// folder, or the result.json in it. Throws InputError for a folder without a finished run, and for files that no run
/// writes.
RunResults readRunResults(const std::filesystem::path& place);

} // namespace meltpool
