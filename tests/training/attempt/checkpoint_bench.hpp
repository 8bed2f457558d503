// What the tests of checkpoints share: a small lesson of each process, a torch for it, and how an attempt ended.
#pragma once

#include "core/training/trainer/trainer.hpp"

#include <string>
#include <vector>

namespace meltpool::test {

/// "flame", "gtaw", "gmaw", "smaw", "iron" and "classic".
const std::vector<std::string>& checkpointProcesses();

/// A lesson of some hundred to two thousand particles.
Lesson checkpointLesson(const std::string& process);

/// The torch of step number `step`, whichever way the lesson came to it.
TorchSample checkpointTorch(const std::string& process, size_t step);

/// Makes steps until there are `step` of them.
void runTo(Trainer& trainer, const std::string& process, size_t step);

/// All that must be the same at the end, in words that tell two ends apart.
std::string endOf(Trainer& trainer);

} // namespace meltpool::test
