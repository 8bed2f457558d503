// result.json: the figures of a run in a form that programs and people read.
#pragma once

#include "core/training/trainer.hpp"
#include "core/weld/gauge/weld_section.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meltpool {

/// What a result says beside the metal's figures.
struct ResultContext {
    std::string version;
    std::string commit;
    std::string renderer;
    double wallSeconds = 0;
    std::optional<WeldSection> section = {}; ///< of weld lessons
    Judgement judgement = {};
    std::string error = {}; ///< why the run ended early; empty when it did not
};

/// Writes what a run is about to do, marked as not finished: what stands in the folder of a run that was killed.
/// `context.error` says so in a sentence. Throws what writeFile() throws.
void writeUnfinishedResult(const std::filesystem::path& file, Lesson& lesson, const ResultContext& context);

/// Writes the figures of a run together with every parameter it had. It is finished where the context has no error.
/// Throws what writeFile() throws.
void writeResult(const std::filesystem::path& file, Lesson& lesson, const LessonResult& result,
                 const ResultContext& context);

} // namespace meltpool
