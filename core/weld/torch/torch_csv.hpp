// The recorded form of a torch path: a CSV table, one row a moment.
#pragma once

#include "core/weld/torch/torch_sample.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// The columns that every recording has, in the order in which they are written.
std::span<const std::string_view> torchColumns();

/// The further columns of a filler rod, of which a recording has all or none: `rod_x_mm` .. `rod_z_mm`, `rod_qx` ..
/// `rod_qw`, and `rod_feed` in mm/s. A row whose eight cells are empty has no rod.
std::span<const std::string_view> rodColumns();

struct TorchRecording {
    std::vector<TorchSample> samples; ///< times ascend; orientations have unit length
    std::vector<std::string> furtherColumns;
    std::vector<std::vector<std::string>> furtherCells; ///< one row a sample, one cell a further column, as written
};

/// What readTorchCsv() does with columns that a torch path does not need. They take many times the memory of the rest.
enum class FurtherColumns { kept, dropped };

/// Reads `time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,trigger`, rodColumns() where they are, and whatever further columns there
/// are, in any order; `#` starts a comment. Throws InputError naming file and line for a missing column or cell,
/// anything that is not a finite number in its range, a time before the row above, a quaternion whose length is not
/// near 1, a line of more than 64 KiB, or more than kLargestTextFile.
TorchRecording readTorchCsv(const std::filesystem::path& file, FurtherColumns further = FurtherColumns::kept);

/// Puts the required cells of one row behind `text` as readTorchCsv() reads them back to the same bits, without an end
/// of line.
void appendTorchRow(std::string& text, const TorchSample& sample);

/// The eight cells of a rod behind `text`, empty ones without a rod.
void appendRodCells(std::string& text, const std::optional<RodSample>& rod);

/// The whole table, with columns of the rod where a sample has one. Throws InputError when the file cannot be written.
void writeTorchCsv(const std::filesystem::path& file, const TorchRecording& recording);

} // namespace meltpool
