// Shared parts of the checkpoint tests: a small lesson of each process, a torch for it, and an attempt's final state.
#pragma once

#include "core/training/trainer/trainer.hpp"

#include <string>
#include <vector>

namespace meltpool::test {

/// Returns "flame", "gtaw", "gmaw", "smaw", "iron" and "classic".
const std::vector<std::string>& checkpointProcesses();

/// Returns a lesson of some hundred to two thousand particles.
Lesson checkpointLesson(const std::string& process);

/// Returns the torch of step number `step`, independent of the steps before it.
TorchSample checkpointTorch(const std::string& process, size_t step);

/// Makes steps until their number is `step`.
void runTo(Trainer& trainer, const std::string& process, size_t step);

/// Returns everything that must be equal at the end, in words that distinguish two ends.
std::string endOf(Trainer& trainer);

} // namespace meltpool::test
