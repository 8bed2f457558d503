// Converts the judgement of an attempt to entries of result.json.
#pragma once

#include "core/training/judging/judgement.hpp"
#include "core/training/lesson/lesson.hpp"

#include <nlohmann/json.hpp>

namespace meltpool {

/// JSON has no number for a value that is not finite: null.
nlohmann::ordered_json jsonNumber(double value);

/// Adds `score`, `arc`, `verdict` and `weld`, as far as they exist. The handbook's page on file formats describes them.
void addJudgement(nlohmann::ordered_json& json, const Judgement& judgement, const Lesson& lesson);

} // namespace meltpool
