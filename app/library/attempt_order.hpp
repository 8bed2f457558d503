// The stored attempts of a list: which of them a filter lets through, and in which order they are shown.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

struct ReplayEntry {
    std::filesystem::path file;
    std::string lesson;           ///< key
    std::string detail;           ///< date, duration and score
    std::string lessonTitle = {}; ///< the lesson's key if the catalogue has no such lesson
    std::string title = {};       ///< name that a person gave the attempt; empty: none
    std::string when = {};        ///< start: "2026-11-23 08:10"
    double seconds = 0;           ///< s of the metal's time
    std::optional<int> score = {};
    std::string verdict = {}; ///< "accepted" or "not accepted"; empty: none
    bool practice = false;    ///< went back to an earlier checkpoint
    bool test = false;        ///< welded for score
};

/// Columns by which a list can be sorted.
enum class AttemptColumn { lesson, title, date, length, score, test };

struct AttemptOrder {
    AttemptColumn column = AttemptColumn::date;
    bool ascending = false;
    bool operator==(const AttemptOrder&) const = default;
};

/// Order after a press on a column's heading: the other direction, or the column's usual one, which begins with the
/// newest, longest, best, and with tests.
AttemptOrder pressedColumn(AttemptOrder order, AttemptColumn column);

struct AttemptFilter {
    std::string text;   ///< words that lesson, name or date contain, in any letters; empty: all
    std::string lesson; ///< key; empty: all
    bool testsOnly = false;
    bool operator==(const AttemptFilter&) const = default;
};

/// Indices of the entries that the filter lets through, in this order. `entries`: newest first, and so are those that
/// the column does not tell apart. Attempts without a score come last in both directions.
std::vector<size_t> orderedAttempts(std::span<const ReplayEntry> entries, const AttemptFilter& filter,
                                    AttemptOrder order);

} // namespace meltpool
