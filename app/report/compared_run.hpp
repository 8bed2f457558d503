// A run's results as one side of a comparison.
#pragma once

#include "app/report/run_results.hpp"
#include "core/training/attempt/differences.hpp"

#include <string>

namespace meltpool {

struct ComparedRun {
    std::string name; ///< for people
    RunResults results;
};

/// The figures of a run as its files have them: the same that figuresOf() takes from a judgement. What is not there, or
/// not what a run writes, is left out.
AttemptFigures figuresOf(const RunResults& results);

Comparison compareRuns(const ComparedRun& first, const ComparedRun& second);

} // namespace meltpool
