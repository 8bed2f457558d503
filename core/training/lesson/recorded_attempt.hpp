// What a record or a recording says beside its torch path: which lesson with which values it was, and what was changed
// on the way.
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

/// A value that became another one between two steps.
struct RecordedChange {
    size_t steps = 0; ///< that had been made before
    std::string key;
    std::string value;
    int line = 0;       ///< in the record; of a recording the frame
    double seconds = 0; ///< of a recording: the metal's time
};

/// Something that happened between two steps. `torch lost`, `torch seen` and `samples dropped` spoil the score.
struct RecordedEvent {
    size_t steps = 0; ///< that had been made before
    std::string name;
    std::string value;
};

struct RecordedAttempt {
    std::filesystem::path file;
    bool framed = false;                 ///< the file is a recording; else a record
    AttemptHead head;                    ///< without its values; date: of the file, local, as formatDate()
    std::vector<RecordedChange> values;  ///< at the start
    std::vector<RecordedChange> changes; ///< in the order of the steps
    std::vector<RecordedEvent> events;   ///< in the same order
    std::vector<RecordedEvent> notes;    ///< all other events: zoom, cues, redo ..., as they came
    std::string ended;                   ///< why; empty where the program ended without warning
    std::string stateHash;               ///< of the metal at the end; empty as above
    std::optional<double> realTime;      ///< simulated over real time; nothing where no person welded
    size_t rows = 0;
    size_t redone = 0; ///< times that it went back and on to another end: practice, where it is not 0
};

/// What a record or a recording says of its attempt; nothing for a torch path that is neither. Throws InputError naming
/// file and line (of a recording frame and second) for what cannot be understood, a file that cannot be read, or a
/// recording that is damaged.
std::optional<RecordedAttempt> readRecordedAttempt(const std::filesystem::path& file);

/// Whether a repetition of `steps` steps that ended in this state has the attempt's bits; nothing where it is of
/// another length, or the attempt ended without warning.
std::optional<bool> sameEnd(const RecordedAttempt& attempt, size_t steps, std::uint64_t stateHash);

/// Makes `lesson` the recorded one: its values at the start and its changes. Throws InputError naming file
/// and line where the lesson is another one or a value does not fit.
void repeatAttempt(Lesson& lesson, const RecordedAttempt& attempt);

/// Gives the lesson the torch path of a file as its demonstration; where the file is a record or a recording, also the
/// values, changes and length of its attempt. Throws as TorchPath::read(), readRecordedAttempt() and repeatAttempt().
void takeTorch(Lesson& lesson, const std::filesystem::path& file);

} // namespace meltpool
