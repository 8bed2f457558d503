// result.json: the figures of a run in a form that programs and people read.
#pragma once

#include "core/training/trainer/trainer.hpp"
#include "core/weld/gauge/weld_section.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meltpool {

/// How an attempt was made, beside what the hand did. What nobody knows is empty.
struct AttemptFacts {
    AttemptHead head; ///< date, program and driver of it are told
    std::optional<bool> forScore;
    std::optional<double> realTime; ///< simulated over real time
    std::optional<double> zoom;     ///< size at which the workpiece was shown
    std::optional<bool> guided;     ///< the torch went along the seam by itself
    std::optional<bool> changed;    ///< workpiece, particles or given settings were others than the lesson's
    std::string cues;               ///< that were shown, by name; empty: none that is known
    std::string ghost;              ///< whose torch was shown: "expert", "best" or "file"; empty: none that is known
};

/// What a record tells of how its attempt was made.
AttemptFacts factsOf(const RecordedAttempt& attempt);

/// What a result says beside the metal's figures.
struct ResultContext {
    std::string version;
    std::string commit;
    std::string renderer;
    double wallSeconds = 0;
    std::optional<WeldSection> section = {}; ///< of weld lessons
    Judgement judgement = {};
    std::string error = {};                   ///< why the run ended early; empty when it did not
    std::string date = {};                    ///< when the result was made, as formatDate(); empty: not told
    std::optional<AttemptFacts> attempt = {}; ///< where a person welded, or a record of an attempt is repeated
    std::vector<std::pair<std::string, std::string>> whatIf = {}; ///< what was changed of a recorded attempt
    std::vector<std::string> warnings = {};                       ///< sentences of what is implausible
    size_t surfaceBytes = 0;                                      ///< GPU memory of the pictures' surface
};

/// The entries of result.json: the figures of a run together with every parameter it had. `result`: null where there is
/// no metal, as where a record alone is judged. The run is finished where the context has no error.
nlohmann::ordered_json resultEntries(Lesson& lesson, const LessonResult* result, const ResultContext& context);

/// Writes what a run is about to do, marked as not finished: what stands in the folder of a run that was killed.
/// `context.error` says so in a sentence. Throws what writeFile() throws.
void writeUnfinishedResult(const std::filesystem::path& file, Lesson& lesson, const ResultContext& context);

/// Writes resultEntries() as text. Throws what writeFile() throws.
void writeResult(const std::filesystem::path& file, Lesson& lesson, const LessonResult& result,
                 const ResultContext& context);

} // namespace meltpool
