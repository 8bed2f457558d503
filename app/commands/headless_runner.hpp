// Runs a lesson's demonstration without a screen and leaves result.json, telemetry.csv and pictures in a folder.
#pragma once

#include "core/gl/context.hpp"
#include "core/gl/program.hpp"
#include "core/training/trainer.hpp"

#include <atomic>
#include <filesystem>

namespace meltpool {

/// Set from a signal or another thread to end a run early; what it had is kept.
using StopFlag = std::atomic<bool>;

/// Makes the folder where it is missing. Throws InputError when that cannot be done.
void prepareOutputFolder(const std::filesystem::path& folder);

/// Runs the lesson to its end. When it fails midway the record is flushed and result.json says why under "error"; the
/// failure is then thrown on: InputError when the folder cannot be written at all, RuntimeFault for a full disk, a
/// metal that is no longer finite or a run that was stopped.
LessonResult runHeadless(const gl::ContextInfo& driver, gl::ShaderLibrary& shaders, const Lesson& lesson,
                         const std::filesystem::path& folder, const StopFlag& stop);

/// How many fixed steps make `seconds`: the smallest number that reaches them.
size_t stepsFor(double seconds, double timeStep);

/// The name of a picture at `time` s, such as "001.500s-metal.png"; names sort by time.
std::string runPictureName(double time, const std::string& look);

} // namespace meltpool
