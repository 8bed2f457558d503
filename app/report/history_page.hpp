// The page that draws results over time.
#pragma once

#include "app/report/result_history.hpp"

#include <string>

namespace meltpool {

/// One HTML page without loaded content: for each machine a drawing of each series, from 0 to its greatest value, with
/// a dot for each result, and a table of the values by commit.
std::string historyPage(const ResultHistory& history);

} // namespace meltpool
