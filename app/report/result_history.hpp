// Results of `bench` and `validate` by machine and commit, as series over time.
#pragma once

#include "core/base/moment.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// One result in a series.
struct HistoryPoint {
    Moment made;
    std::string commit;
    double value = 0;
};

/// One measurement over time, the oldest result first.
struct HistorySeries {
    std::string group; ///< suite of the benchmark, or set of validation cases
    std::string name;
    std::string unit; ///< ms, bytes, %; empty for a ratio
    std::vector<HistoryPoint> points;
};

/// Series of one machine; groups in the order of their names.
struct MachineHistory {
    std::string machine; ///< see machineOf()
    std::vector<HistorySeries> series;
};

/// All results in a folder.
struct ResultHistory {
    std::vector<MachineHistory> machines;
    std::vector<std::filesystem::path> leftOut; ///< JSON files that are no complete result of bench or validate
};

/// Reads all .json files in the folder and below it. Of a benchmark's row it takes the least time, the bytes of a
/// particle and the simulated over the real time; of a validation the mean error of each quantity. Throws InputError
/// if there is no folder, or if a file is not JSON.
ResultHistory readResultHistory(const std::filesystem::path& folder);

} // namespace meltpool
