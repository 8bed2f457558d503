// The stored attempts as rows of a table, for spreadsheets and programs.
#pragma once

#include "app/library/kept_attempts.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <span>
#include <string>

namespace meltpool {

/// Columns of an attempt in the table, and its keys in JSON.
inline constexpr std::array kAttemptColumns{"date",       "lesson",    "lesson_file", "attempt",   "seconds",
                                            "score",      "verdict",   "practice",    "real_time", "ended",
                                            "state_hash", "bytes",     "program",     "driver",    "file",
                                            "person",     "person_id", "title",       "test"};

/// Values of an attempt, in the order of the columns; null for what it does not have. Reads its head and end. Throws
/// as readRecordingSummary().
std::array<nlohmann::ordered_json, kAttemptColumns.size()> attemptRow(const KeptAttempt& kept);

/// The table by RFC 4180: the columns, then a row for each attempt in this order. Throws as attemptRow().
std::string attemptsCsv(std::span<const KeptAttempt> attempts);

} // namespace meltpool
