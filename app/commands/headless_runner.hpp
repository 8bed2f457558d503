// The runner of a lesson's demonstration without a screen: leaves result.json, telemetry.csv and pictures in a folder.
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

/// Request to end a run early; its results so far are stored.
struct RunStop {
    std::function<bool()> asked;
    /// Called when the run is about to end in order.
    std::function<void()> grant;
    /// Sets the work to do, on another thread, before a run that was asked to stop but does not reach its next step is
    /// ended.
    std::function<void(const std::function<void()>& last)> endAfter;
};

/// Output files of a run.
struct RunPlaces {
    std::filesystem::path result;
    std::filesystem::path telemetry;
    std::filesystem::path folder;     ///< folder of the pictures, technique.csv and weld.csv
    std::filesystem::path sound = {}; ///< WAV file of the sound; empty: none
    std::filesystem::path mesh = {};  ///< surface of the metal at the end, see writeMesh(); empty: none
};

/// Differences of a run from the lesson's demonstration; an empty value makes none.
struct RunHooks {
    /// Returns the torch of the next step, after the recorded changes before it are made.
    std::function<TorchSample(const Trainer&)> torch = {};
    /// Puts the metal to the run's start, such as a checkpoint; the steps that the trainer then has count.
    std::function<void(Trainer&)> start = {};
    TorchPath ghost = {}; ///< path of a ghost in the pictures, by place on the seam; it affects nothing else
    std::vector<std::pair<std::string, std::string>> whatIf = {}; ///< see ResultContext
    FilmRequest film = {};
    std::vector<std::string> warnings = {}; ///< warnings for the result, see pathWarnings()
    /// Takes a warning that only the run's end shows, and that is also in the result.
    std::function<void(const std::string&)> warn = {};
};

/// Runs the lesson to its end. Until then the result says that the run is not finished. When it fails, the record is
/// flushed and the result says why under "error"; the failure is then thrown on: InputError when the folder cannot be
/// written at all, RuntimeFault for a full disk, a metal that is no longer finite or a run that was stopped.
LessonResult runHeadless(const gl::ContextInfo& driver, gl::ShaderLibrary& shaders, const Lesson& lesson,
                         const RunPlaces& places, const RunStop& stop, const RunHooks& hooks = {});

/// Throws RuntimeFault if the metal is no longer finite, by the trainer's newest figures.
void requireFinite(const Trainer& trainer);

/// Count of fixed steps for `seconds`: the smallest number that reaches them.
size_t stepsFor(double seconds, double timeStep);

/// Steps of a whole run of the lesson that the trainer has begun: those of the recorded attempt if it is repeated to
/// its end.
size_t stepsOfRun(const Trainer& trainer);

/// Name of a picture at `time` s, such as "001.500s-metal.png"; names sort by time.
std::string runPictureName(double time, const std::string& look);

} // namespace meltpool
