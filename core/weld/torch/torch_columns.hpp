// Mapping of a table's columns to the parts of a torch path: names in any case, with blanks or with a unit.
#pragma once

#include "core/base/table_reader.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Returns the columns that every recording has, in the order in which they are written.
std::span<const std::string_view> torchColumns();

/// Returns the further columns of a filler rod, of which a recording has all or none: `rod_x_mm` .. `rod_z_mm`,
/// `rod_qx` .. `rod_qw`, and `rod_feed` in mm/s. A row whose eight cells are empty has no rod.
std::span<const std::string_view> rodColumns();

inline constexpr std::size_t kTorchColumns = 9;
inline constexpr std::size_t kRodColumns = 8;

/// A column of the table that belongs to the path.
struct FoundColumn {
    std::size_t place = 0; ///< index in the table's rows
    std::string name;      ///< name as the table has it
    double factor = 1;     ///< factor from its numbers to s, mm or mm/s
};

/// Unit of the times according to the header.
enum class TimeUnitName { none, seconds, other };

/// The header of a torch path.
struct TorchHeader {
    std::array<FoundColumn, kTorchColumns> torch; ///< columns in the order of torchColumns()
    std::array<FoundColumn, kRodColumns> rod;     ///< columns in the order of rodColumns()
    bool hasRod = false;
    std::vector<std::size_t> further; ///< indices of all other columns
    TimeUnitName timeUnit = TimeUnitName::none;
    bool placesWithoutUnit = false; ///< `x` and the like, read as mm
};

/// Returns true if a name is a column of torch or rod, in any form.
bool isTorchColumn(std::string_view name);

/// Finds the columns. A name as in torchColumns() and rodColumns() is taken first; if there is none, a name that
/// differs in case, blanks and unit: `Time [ms]`, `X (m)`, `t`, `Trigger [%]`. Throws InputError, naming `file` and the
/// header's line, for a column that is missing, that is there twice or that has a unit of another kind.
TorchHeader findTorchColumns(const TableReader& table, const std::filesystem::path& file);

} // namespace meltpool
