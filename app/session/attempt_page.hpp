// The page of a judged attempt, made from the running metal: the same page as of a run.
#pragma once

#include "core/render/renderer.hpp"
#include "core/training/trainer/lesson_scene.hpp"
#include "core/training/trainer/result_file.hpp"

#include <filesystem>
#include <string>

namespace meltpool {

class LessonSession;

/// The page's HTML, with pictures of the weld from outside and cut. `driver`: of the graphics. Waits for the GPU, as
/// judging does. Throws RuntimeFault where driver or memory fail.
std::string attemptPage(LessonScene& scene, Renderer& renderer, const Judgement& judgement, const AttemptFacts& facts,
                        const std::string& driver);

/// A name for it that no file has: that of the attempt's record with .html, else by `lesson` and `date` in the folder
/// of pages, keptFolder() / "pages", which is made. Throws InputError where it cannot be.
std::filesystem::path attemptPageName(const std::filesystem::path& record, const std::string& lesson,
                                      const std::string& date);

/// Writes the page of the session's judged attempt: beside its record, where it has one, else into the user's folder.
/// `zoom` at which the workpiece was shown; `driver` of the graphics. Answers where it is. Waits for the GPU. Throws
/// InputError where nothing is judged or nothing can be written there, RuntimeFault where the machine fails.
std::filesystem::path writeAttemptPage(LessonSession& session, double zoom, const std::string& driver);

} // namespace meltpool
