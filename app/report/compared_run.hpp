// A run's results as one side of a comparison.
#pragma once

#include "app/report/run_results.hpp"
#include "core/training/attempt/differences.hpp"

#include <string>

namespace meltpool {

struct ComparedRun {
    std::string name; ///< name for people
    RunResults results;
};

/// Figures of a run from its files, equal to those that figuresOf() takes from a judgement. Values that are missing, or
/// that no run writes, are left out.
AttemptFigures figuresOf(const RunResults& results);

Comparison compareRuns(const ComparedRun& first, const ComparedRun& second);

} // namespace meltpool
