// An attempt as a demonstration: the torch path without idle time, and a lesson file that uses it.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <vector>

namespace meltpool {

/// s of the hand's motion in a demonstration before the first pull of the trigger and after the last release.
inline constexpr double kDemonstrationLead = 1;

/// Stretch of an attempt in which the arc welded.
struct WeldedStretch {
    double begin = 0, end = 0;        ///< s of the attempt, with kDemonstrationLead if there is as much
    double firstPull = 0;             ///< s of the attempt
    std::vector<TorchSample> samples; ///< samples whose times begin at 0
};

/// Cuts the attempt that the lesson has taken (see takeTorch()). Throws InputError if the trigger was never pulled.
WeldedStretch weldedStretch(const Lesson& lesson);

/// Text of the lesson's file with `path`, next to `file`, as its torch, the values that the attempt had when its
/// trigger was first pulled, and as long as the path and the lesson's own time after its demonstration take. Files that
/// the lesson names can still be found from `file`. Comments are lost. The lesson must be one from a file.
std::string demonstrationLesson(const Lesson& lesson, const WeldedStretch& stretch, const std::filesystem::path& path,
                                const std::filesystem::path& file);

} // namespace meltpool
