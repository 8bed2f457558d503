// The judgement of an attempt as entries of result.json.
#pragma once

#include "core/training/judging/judgement.hpp"
#include "core/training/lesson/lesson.hpp"

#include <nlohmann/json.hpp>

namespace meltpool {

/// JSON has no number for what is not finite: null.
nlohmann::ordered_json jsonNumber(double value);

/// Adds `score`, `arc`, `verdict` and `weld`, each where there is one. The handbook's page on file formats tells what
/// they hold.
void addJudgement(nlohmann::ordered_json& json, const Judgement& judgement, const Lesson& lesson);

} // namespace meltpool
