// Writes result.json: the figures of a run in a form for programs and people.
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

/// Circumstances of an attempt, other than the hand. Unknown ones are empty.
struct AttemptFacts {
    AttemptHead head; ///< person, date, program and driver are written
    std::optional<bool> forScore;
    std::optional<double> realTime; ///< simulated time over real time
    std::optional<double> zoom;     ///< scale of the shown workpiece
    std::optional<bool> guided;     ///< true: the torch moved along the seam by itself
    std::optional<bool> swung;      ///< true: the torch swung across the seam by itself
    std::string held;               ///< judged quantities that the desk held: "aim travel_speed"; empty: none known
    std::optional<bool> changed;    ///< true: workpiece, particles or given settings differed from the lesson's
    std::string cues;               ///< shown cues, by name; empty: none known
    std::string ghost;              ///< source of the shown torch: "expert", "best" or "file"; empty: none known
};

/// Circumstances of the attempt in a record.
AttemptFacts factsOf(const RecordedAttempt& attempt);

/// Contents of a result other than the metal's figures.
struct ResultContext {
    std::string version;
    std::string commit;
    std::string renderer;
    double wallSeconds = 0;
    std::optional<WeldSection> section = {}; ///< section of a weld lesson
    Judgement judgement = {};
    std::string error = {};                   ///< reason why the run ended early; else empty
    std::string date = {};                    ///< date of the result, as formatDate(); empty: not written
    std::optional<AttemptFacts> attempt = {}; ///< if a person welded, or a record of an attempt is repeated
    std::vector<std::pair<std::string, std::string>> whatIf = {}; ///< changes of a recorded attempt
    std::vector<std::string> warnings = {};                       ///< sentences about implausible values
    size_t surfaceBytes = 0;                                      ///< GPU memory of the pictures' surface
};

/// The entries of result.json: the figures of a run together with every parameter it had. `result`: null without a
/// metal, for example if only a record is judged. A run is finished if the context has no error.
nlohmann::ordered_json resultEntries(Lesson& lesson, const LessonResult* result, const ResultContext& context);

/// Writes the plan of a run, marked as not finished, so that the folder of a killed run has a result. `context.error`
/// says so in a sentence. Throws as writeFile().
void writeUnfinishedResult(const std::filesystem::path& file, Lesson& lesson, const ResultContext& context);

/// Writes resultEntries() as text. Throws as writeFile().
void writeResult(const std::filesystem::path& file, Lesson& lesson, const LessonResult& result,
                 const ResultContext& context);

} // namespace meltpool
