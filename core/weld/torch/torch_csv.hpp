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

/// What the reader of a table found out or assumed of it.
struct TorchForm {
    TableForm table;
    TorchClock clock;
    bool placesWithoutUnit = false; ///< they are taken to be mm
    size_t unseenRows = 0;          ///< rows without a pose
    bool ours = false;              ///< a record of this program, of which nothing is assumed

    /// In one line: "UTF-8, columns parted by commas, decimal point, times in s".
    std::string text() const;
};

struct TorchRecording {
    std::vector<TorchSample> samples; ///< times ascend; orientations have unit length
    std::vector<std::string> furtherColumns;
    std::vector<std::vector<std::string>> furtherCells; ///< one row a sample, one cell a further column
    TorchForm form = {};                                ///< as the table was read
};

/// What readTorchCsv() does with columns that a torch path does not need. They take many times the memory of the rest.
enum class FurtherColumns { kept, dropped };

/// Whether a file's name ends as those of recorded torch paths do: .csv, .tsv or .txt, in any case.
bool isTorchTable(const std::filesystem::path& file);

/// Reads the columns of findTorchColumns() and whatever further ones there are, in any order, from a table as
/// TableReader takes it. A row in which every cell of the pose is empty or `nan` is not seen: the torch stays where it
/// was seen last, its trigger released. Times become those of settleTimes(). Throws InputError naming file and line
/// for a missing column or cell, anything that is not a finite number in its range, a time before the row above, more
/// than a day, a quaternion whose length is not near 1, no row with a pose, what TableReader refuses, or more than
/// kLargestTextFile.
TorchRecording readTorchCsv(const std::filesystem::path& file, FurtherColumns further = FurtherColumns::kept);

/// Puts the required cells of one row behind `text` as readTorchCsv() reads them back to the same bits, without an end
/// of line.
void appendTorchRow(std::string& text, const TorchSample& sample);

/// The eight cells of a rod behind `text`, empty ones without a rod.
void appendRodCells(std::string& text, const std::optional<RodSample>& rod);

/// The whole table, with columns of the rod where a sample has one. Throws InputError when the file cannot be written.
void writeTorchCsv(const std::filesystem::path& file, const TorchRecording& recording);

} // namespace meltpool
