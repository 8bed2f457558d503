// The page of a judged attempt, made from the running metal: the page that a run of the lesson writes, too.
#pragma once

#include "core/render/renderer.hpp"
#include "core/training/trainer/lesson_scene.hpp"
#include "core/training/trainer/result_file.hpp"

#include <filesystem>
#include <string>

namespace meltpool {

class LessonSession;

/// HTML of the page, with pictures of the weld from outside and cut. `driver`: name of the graphics driver. Waits for
/// the GPU, as judging does. Throws RuntimeFault when driver or memory fail.
std::string attemptPage(LessonScene& scene, Renderer& renderer, const Judgement& judgement, const AttemptFacts& facts,
                        const std::string& driver);

/// File name for the page that no file has yet: the record's with .html, or one from `lesson` and `date` in
/// keptFolder() / "pages", which it creates. Throws InputError when the folder cannot be created.
std::filesystem::path attemptPageName(const std::filesystem::path& record, const std::string& lesson,
                                      const std::string& date);

/// Page of a stored recording in keptFolder() / "pages": the one that was written of its judged weld, or one that is
/// made of the recording alone. Throws InputError if the recording or its lesson cannot be used, or the page cannot be
/// written.
std::filesystem::path keptAttemptPage(const std::filesystem::path& recording);

/// Writes the page of the session's judged attempt next to its record, or into the user's folder if it has none, and
/// returns its path. `zoom`: scale at which the workpiece was shown. `driver`: name of the graphics driver. Waits for
/// the GPU. Throws InputError when nothing is judged or the place is not writable, RuntimeFault when driver or memory
/// fail.
std::filesystem::path writeAttemptPage(LessonSession& session, double zoom, const std::string& driver);

} // namespace meltpool
