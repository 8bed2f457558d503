// Checks the result of a lesson's demonstration, or of another torch path, against a file with an [expect] table.
#pragma once

#include "core/base/toml_table.hpp"
#include "core/training/judging/judgement.hpp"
#include "core/training/lesson/lesson_folders.hpp"
#include "core/training/lesson/path_perturbation.hpp"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace meltpool {

/// One line of [expect].
struct Expectation {
    std::string key;
    /// A range, both ends included, a yes or no, or a word.
    std::variant<NumberRange, bool, std::string> wanted;
};

struct LessonCheck {
    std::filesystem::path file;
    std::string name; ///< file name without its extension
    Lesson lesson;    ///< lesson with the check's torch path and values
    PathPerturbation bend;
    std::vector<Expectation> expectations; ///< sorted by key
};

/// True if a TOML file is a check: it has a table [expect]. Throws InputError for a file that is not TOML.
bool isLessonCheck(const std::filesystem::path& file);

/// Reads a check:
///
///     lesson = "gmaw-bead"       # a name of the catalogue, or a file in this folder
///     torch = "slow.csv"         # instead of the lesson's own; in this folder. A record brings its attempt's values
///     [set]                      # values of the lesson
///     voltage = 22
///     [bend]                     # worsens the path, see PathPerturbation
///     time = 0.55
///     farther_mm = 7
///     turn_deg = 28
///     aside_mm = 4
///     tremor_seed = 1
///     tremor_mm = 0.1            # instead of a practised hand's
///     tremor_deg = 0
///     [expect]
///     score = [90, 100]          # the whole score
///     scored = true
///     accepted = true            # by the lesson's acceptance
///     lowest = "travel_speed"    # the parameter with the fewest points
///     travel_speed = [0, 70]     # points of a parameter
///     toe_width_mm = [6, 9]      # any figure of weld.csv, as the mean over the weld
///     overlap = "pass"           # the state of an imperfection
///
/// A file without `lesson` is a lesson itself, welded by its own demonstration. `lessons` are those of the catalogue.
/// Throws InputError with file, line and key for an unknown or missing key and an impossible value.
LessonCheck readLessonCheck(const std::filesystem::path& file, const LessonFolders& lessons);

/// An expectation and its result.
struct CheckedValue {
    std::string key;
    std::string expected; ///< such as "90 to 100"
    std::string found;    ///< such as "97.3"; "none" if the attempt has no such value
    bool passed = false;
};

std::vector<CheckedValue> checkJudgement(const LessonCheck& check, const Judgement& judgement);

} // namespace meltpool
