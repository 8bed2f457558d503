// An attempt as a demonstration: the torch path without idle time, and a lesson file that uses it.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <vector>

namespace meltpool {

/// s of the hand that a demonstration keeps before the first pull of the trigger and after the last release.
inline constexpr double kDemonstrationLead = 1;

/// The stretch of an attempt in which something was welded.
struct WeldedStretch {
    double begin = 0, end = 0;        ///< s of the attempt, with kDemonstrationLead where there is as much
    double firstPull = 0;             ///< s of the attempt
    std::vector<TorchSample> samples; ///< their times begin at 0
};

/// Cuts the attempt that the lesson has taken (see takeTorch()). Throws InputError where the trigger was never pulled.
WeldedStretch weldedStretch(const Lesson& lesson);

/// The lesson's file anew with `path`, which lies beside `file`, as its torch, the values that the attempt had when its
/// trigger was pulled first, and as long as the path and the lesson's own time after its demonstration take. Files that
/// the lesson names keep being found from `file`. Comments are lost. The lesson must be one from a file.
std::string demonstrationLesson(const Lesson& lesson, const WeldedStretch& stretch, const std::filesystem::path& path,
                                const std::filesystem::path& file);

} // namespace meltpool
