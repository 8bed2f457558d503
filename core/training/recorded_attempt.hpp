// What a record says beside its torch path: which lesson with which values it was, and what was changed on the way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

struct Lesson;

/// A value that became another one between two steps.
struct RecordedChange {
    size_t steps = 0; ///< that had been made before
    std::string key;
    std::string value;
    int line = 0; ///< in the record
};

/// What spoils the score of an attempt, between two steps: `torch lost`, `torch seen`, `samples dropped`.
struct RecordedEvent {
    size_t steps = 0; ///< that had been made before
    std::string name;
    std::string value;
};

struct RecordedAttempt {
    std::filesystem::path file;
    std::string lesson;
    std::string driver;
    std::vector<RecordedChange> values;  ///< at the start
    std::vector<RecordedChange> changes; ///< in the order of the steps
    std::vector<RecordedEvent> events;   ///< in the same order
    std::string ended;                   ///< why; empty where the program ended without warning
    std::string stateHash;               ///< of the metal at the end; empty as above
    std::optional<double> realTime;      ///< simulated over real time; nothing where no person welded
    size_t rows = 0;
};

/// The record's own lines of a torch path in the recorded form; nothing where it is no record of this program. Throws
/// InputError naming file and line for a line of the record that cannot be understood, or a file that cannot be read.
std::optional<RecordedAttempt> readRecordedAttempt(const std::filesystem::path& file);

/// Whether a repetition of `steps` steps that ended in this state has the attempt's bits; nothing where it is of
/// another length, or the attempt ended without warning.
std::optional<bool> sameEnd(const RecordedAttempt& attempt, size_t steps, std::uint64_t stateHash);

/// Makes `lesson` the recorded one: its values at the start and its changes. Throws InputError naming file
/// and line where the lesson is another one or a value does not fit.
void repeatAttempt(Lesson& lesson, const RecordedAttempt& attempt);

/// Gives the lesson the torch path of a file as its demonstration; where the file is a record, also the values, changes
/// and length of its attempt. Throws as TorchPath::read(), readRecordedAttempt() and repeatAttempt().
void takeTorch(Lesson& lesson, const std::filesystem::path& file);

} // namespace meltpool
