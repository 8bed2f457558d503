// Reads from a record or a recording its lesson, its values, and the changes during the attempt, besides the torch
// path.
#pragma once

#include "core/training/attempt/attempt_head.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

struct Lesson;

/// A value that changed between two steps.
struct RecordedChange {
    size_t steps = 0; ///< steps made before
    std::string key;
    std::string value;
    int line = 0;       ///< line in a record, frame in a recording
    double seconds = 0; ///< metal time, in a recording
};

/// An event between two steps. `torch lost`, `torch seen` and `samples dropped` spoil the score.
struct RecordedEvent {
    size_t steps = 0; ///< steps made before
    std::string name;
    std::string value;
};

struct RecordedAttempt {
    std::filesystem::path file;
    bool framed = false;                 ///< true: a recording; false: a record
    AttemptHead head;                    ///< without its values; date: the file's, local, as formatDate()
    std::vector<RecordedChange> values;  ///< values at the start of the attempt
    std::vector<RecordedChange> changes; ///< sorted by step
    std::vector<RecordedEvent> events;   ///< sorted by step
    std::vector<RecordedEvent> notes;    ///< all other events: zoom, cues, redo ..., in the file's order
    std::string ended;                   ///< reason of the end; empty if the program ended without warning
    std::string stateHash;               ///< hash of the metal's state at the end; empty as above
    std::optional<double> realTime;      ///< simulated time over real time; empty if no person welded
    std::optional<double> firstArc;      ///< metal time at which an arc first burned, s; empty without one
    size_t rows = 0;
    size_t redone = 0; ///< times that it went back and on to another end; not 0 means practice
};

/// Reads the attempt of a record or a recording; empty for a torch path that is neither. Throws InputError naming file
/// and line (for a recording frame and second) if a line cannot be understood, the file cannot be read, or the
/// recording is damaged.
std::optional<RecordedAttempt> readRecordedAttempt(const std::filesystem::path& file);

/// True if a repetition of `steps` steps that ended in this state has the attempt's bits; empty if its length differs
/// or the attempt ended without warning.
std::optional<bool> sameEnd(const RecordedAttempt& attempt, size_t steps, std::uint64_t stateHash);

/// Makes `lesson` the recorded one: its values at the start and its changes. Throws InputError naming file and line if
/// the lesson is another one or a value does not fit.
void repeatAttempt(Lesson& lesson, const RecordedAttempt& attempt);

/// Makes the torch path of a file the lesson's demonstration; a record or a recording also gives the values, changes
/// and length of its attempt. Throws as TorchPath::read(), readRecordedAttempt() and repeatAttempt().
void takeTorch(Lesson& lesson, const std::filesystem::path& file);

} // namespace meltpool
