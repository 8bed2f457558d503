// Runs a lesson's demonstration without a screen and leaves result.json, telemetry.csv and pictures in a folder.
#pragma once

#include "app/export/film.hpp"
#include "core/gl/context.hpp"
#include "core/gl/program.hpp"
#include "core/training/trainer/trainer.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

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
    std::filesystem::path folder;     ///< of the pictures, technique.csv and weld.csv
    std::filesystem::path sound = {}; ///< WAV file of what is heard; empty: none
    std::filesystem::path mesh = {};  ///< of the metal at the end, see writeMesh(); empty: none
};

/// How a run differs from the lesson's demonstration; what is empty is as that has it.
struct RunHooks {
    /// The torch of the next step, after the recorded changes before it are made.
    std::function<TorchSample(const Trainer&)> torch = {};
    /// Puts the metal where the run begins, such as at a checkpoint; the steps that the trainer then has count.
    std::function<void(Trainer&)> start = {};
    TorchPath ghost = {}; ///< goes through the pictures by place on the seam and touches nothing else
    std::vector<std::pair<std::string, std::string>> whatIf = {}; ///< see ResultContext
    FilmRequest film = {};
    std::vector<std::string> warnings = {}; ///< that stand in the result, see pathWarnings()
    /// Is given a warning that only the run's end shows, and that stands in the result too.
    std::function<void(const std::string&)> warn = {};
};

/// Runs the lesson to its end. From the first moment on the result says that the run is not finished. When it fails,
/// the record is flushed and the result says why under "error"; the failure is then thrown on: InputError when the
/// folder cannot be written at all, RuntimeFault for a full disk, a metal that is no longer finite or a run that was
/// stopped.
LessonResult runHeadless(const gl::ContextInfo& driver, gl::ShaderLibrary& shaders, const Lesson& lesson,
                         const RunPlaces& places, const RunStop& stop, const RunHooks& hooks = {});

/// Throws RuntimeFault where the metal is no longer finite, by the trainer's newest figures.
void requireFinite(const Trainer& trainer);

/// How many fixed steps make `seconds`: the smallest number that reaches them.
size_t stepsFor(double seconds, double timeStep);

/// Steps of a whole run of the lesson that the trainer has begun: those of the recorded attempt where it is repeated to
/// its end.
size_t stepsOfRun(const Trainer& trainer);

/// The name of a picture at `time` s, such as "001.500s-metal.png"; names sort by time.
std::string runPictureName(double time, const std::string& look);

} // namespace meltpool
