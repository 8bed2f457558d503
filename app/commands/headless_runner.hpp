// Runs a lesson's demonstration without a screen and leaves result.json, telemetry.csv and pictures in a folder.
#pragma once

#include "core/gl/context.hpp"
#include "core/gl/program.hpp"
#include "core/training/trainer.hpp"

#include <filesystem>
#include <functional>

namespace meltpool {

/// How a run learns that it shall end early; what it had is kept.
struct RunStop {
    std::function<bool()> asked;
    /// The run is about to end in order.
    std::function<void()> grant;
    /// Sets what is done, on another thread, before a run that was asked but does not come to its next step is ended.
    std::function<void(const std::function<void()>& last)> endAfter;
};

/// Where a run writes.
struct RunPlaces {
    std::filesystem::path result;
    std::filesystem::path telemetry;
    std::filesystem::path folder; ///< of the pictures, technique.csv and weld.csv
};

/// Runs the lesson to its end. From the first moment on the result says that the run is not finished. When it fails,
/// the record is flushed and the result says why under "error"; the failure is then thrown on: InputError when the
/// folder cannot be written at all, RuntimeFault for a full disk, a metal that is no longer finite or a run that was
/// stopped.
LessonResult runHeadless(const gl::ContextInfo& driver, gl::ShaderLibrary& shaders, const Lesson& lesson,
                         const RunPlaces& places, const RunStop& stop);

/// Throws RuntimeFault where the metal is no longer finite, by the trainer's newest figures.
void requireFinite(const Trainer& trainer);

/// How many fixed steps make `seconds`: the smallest number that reaches them.
size_t stepsFor(double seconds, double timeStep);

/// The name of a picture at `time` s, such as "001.500s-metal.png"; names sort by time.
std::string runPictureName(double time, const std::string& look);

} // namespace meltpool
