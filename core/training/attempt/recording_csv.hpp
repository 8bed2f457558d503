// A recording as a table.
#pragma once

#include "core/training/attempt/recording.hpp"

#include <string>

namespace meltpool {

/// The record of the attempt, one row a step with torch, rod, arc and real time: a torch path that reads back to the
/// same bits, and a record that repeats the attempt. It has no figures of the metal, which a recording does not hold.
std::string recordingCsv(const Recording& recording);

} // namespace meltpool
