// Writes the lines and cells that records share with tables made of recordings.
#pragma once

#include "core/weld/process/arc.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace meltpool {

/// The first line of every record, without its line end.
inline constexpr std::string_view kRecordFirstLine = "# meltpool record 1";

/// Columns of the arc, behind those of the torch.
inline constexpr std::string_view kArcColumns =
    "arc_length_mm,current_a,voltage_v,arc_state,ctwd_mm,extension_mm,power_w";

/// °C of a temperature in K, for files that people read.
inline double celsius(double kelvin) {
    return kelvin - 273.15;
}

/// Appends the line `PREFIX WORD NAME VALUE` to `text`; empty parts are left out. It always writes one line, even if a
/// part holds line ends.
void appendRecordLine(std::string& text, std::string_view prefix, std::string_view word, std::string_view name,
                      std::string_view value);

/// Appends a comma and the shortest text of a number.
void appendCell(std::string& text, float value);
void appendCell(std::string& text, double value);
void appendCell(std::string& text, std::uint64_t value);

/// Appends the cells of kArcColumns, a comma before each.
void appendArcCells(std::string& text, const ArcState& arc);

} // namespace meltpool
