// The lines and cells that records, and tables made of recordings, have in common.
#pragma once

#include "core/weld/process/arc.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace meltpool {

/// The first line of every record, without its end.
inline constexpr std::string_view kRecordFirstLine = "# meltpool record 1";

/// Columns of the arc behind those of the torch.
inline constexpr std::string_view kArcColumns =
    "arc_length_mm,current_a,voltage_v,arc_state,ctwd_mm,extension_mm,power_w";

/// °C of a temperature in K: what files that people read have.
inline double celsius(double kelvin) {
    return kelvin - 273.15;
}

/// The line `PREFIX WORD NAME VALUE` behind `text`; empty parts are left out. It holds one line, whatever a file or a
/// person has put into the parts.
void appendRecordLine(std::string& text, std::string_view prefix, std::string_view word, std::string_view name,
                      std::string_view value);

/// A comma and the shortest text of a number.
void appendCell(std::string& text, float value);
void appendCell(std::string& text, double value);
void appendCell(std::string& text, std::uint64_t value);

/// The cells of kArcColumns, a comma before each.
void appendArcCells(std::string& text, const ArcState& arc);

} // namespace meltpool
