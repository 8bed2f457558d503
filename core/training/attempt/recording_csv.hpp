// Writes a recording as a table.
#pragma once

#include "core/training/attempt/recording.hpp"

#include <string>

namespace meltpool {

/// The record of the attempt, one row a step with torch, rod, arc and real time. It is a torch path that reads back to
/// the same bits, and a record that repeats the attempt. It has no figures of the metal: a recording does not hold
/// them.
std::string recordingCsv(const Recording& recording);

} // namespace meltpool
