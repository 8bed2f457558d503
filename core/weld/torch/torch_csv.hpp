// The recorded form of a torch path: a CSV table, one row a moment.
#pragma once

#include "core/base/table_reader.hpp"
#include "core/weld/torch/torch_columns.hpp"
#include "core/weld/torch/torch_sample.hpp"
#include "core/weld/torch/torch_times.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Findings and assumptions of the reader about a table.
struct TorchForm {
    TableForm table;
    TorchClock clock;
    bool placesWithoutUnit = false; ///< places are read as mm
    size_t unseenRows = 0;          ///< rows without a pose
    bool ours = false;              ///< a record of this program, about which nothing is assumed

    /// Returns one line: "UTF-8, columns parted by commas, decimal point, times in s".
    std::string text() const;
};

struct TorchRecording {
    std::vector<TorchSample> samples; ///< times ascend; orientations have unit length
    std::vector<std::string> furtherColumns;
    std::vector<std::vector<std::string>> furtherCells; ///< one row a sample, one cell a further column
    TorchForm form = {};                                ///< form of the table
};

/// Treatment of columns that a torch path does not need. They take many times the memory of the rest.
enum class FurtherColumns { kept, dropped };

/// Returns true if a file's name ends like those of recorded torch paths: .csv, .tsv or .txt, in any case.
bool isTorchTable(const std::filesystem::path& file);

/// Reads the columns of findTorchColumns() and all further ones, in any order, from a table as TableReader takes it. In
/// a row in which every cell of the pose is empty or `nan` the torch is not seen: it stays at its last seen place, its
/// trigger released. Times become those of settleTimes(). Throws InputError naming file and line for a missing column
/// or cell, anything that is not a finite number in its range, a time before the row above, more than a day, a
/// quaternion whose length is not near 1, no row with a pose, anything that TableReader refuses, or more than
/// kLargestTextFile.
TorchRecording readTorchCsv(const std::filesystem::path& file, FurtherColumns further = FurtherColumns::kept);

/// Appends the required cells of one row to `text`, without an end of line; readTorchCsv() reads them back to identical
/// bits.
void appendTorchRow(std::string& text, const TorchSample& sample);

/// Appends the eight cells of a rod to `text`, empty ones without a rod.
void appendRodCells(std::string& text, const std::optional<RodSample>& rod);

/// Writes the whole table, with columns of the rod if a sample has one. Throws InputError when the file cannot be
/// written.
void writeTorchCsv(const std::filesystem::path& file, const TorchRecording& recording);

} // namespace meltpool
