// A case that names a row of a maker's chart has the middle of the row's ranges.
#pragma once

#include "core/base/toml_table.hpp"
#include "core/validation/validation_case.hpp"

#include <functional>
#include <map>
#include <string>

namespace meltpool {

/// Values of keys that a case need not give, in the units of the keys.
struct ChartDefaults {
    std::map<std::string, double, std::less<>> numbers;
    std::map<std::string, std::string, std::less<>> words;
};

/// Returns the values of the row that `row` names among the shipped charts: middles of its ranges, the least leg that
/// it calls for, its first gas, and its first position unless the joint lies in one of them anyway. None without the
/// key. Throws InputError for an unknown row, one of another joint than the kind's, and a wire, electrode or thickness
/// that is not the row's.
ChartDefaults chartDefaults(TomlTable& table, const CaseKind& kind);

/// Throws InputError for a position that the joint cannot have, a chart's weld without a process, smaw without a known
/// electrode, and keys that the process has no use for.
void checkChart(TomlTable& table, const ValidationCase& from);

/// Returns the joint of a kind of case: "chart_tee", "chart_lap" or "chart_butt".
int chartJoint(const CaseKind& kind);

} // namespace meltpool
