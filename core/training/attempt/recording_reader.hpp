// Reads recordings: one whole recording, or the summary that a list shows.
#pragma once

#include "core/base/moment.hpp"
#include "core/training/attempt/recording.hpp"
#include "core/weld/torch/torch_path.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace meltpool {

/// True if the name ends like a recording's.
bool isRecording(const std::filesystem::path& file);

/// All whole frames up to the end or the first fault, which is in the returned recording. Throws InputError if the file
/// cannot be read or does not begin like a recording, and, naming frame and second, if an undamaged frame holds values
/// that no attempt has.
Recording readRecording(const std::filesystem::path& file);

/// Reads a recording for use: as readRecording(), but throws InputError, naming frame and second, if it is damaged, and
/// if it holds no step. A recording that was cut short, as by a killed program, is used as far as it goes.
Recording readSoundRecording(const std::filesystem::path& file);

/// The torch of every step, to the bit.
TorchPath torchPathOf(const Recording& recording);

/// The bytes of a checkpoint that readRecording() found in the file. Throws InputError if they are no longer there.
std::vector<std::byte> readCheckpoint(const std::filesystem::path& file, const RecordingCheckpoint& checkpoint);

/// Summary of a recording, read without reading all of it.
struct RecordingSummary {
    AttemptHead head;
    std::optional<RecordingEnd> end;
    double seconds = 0;      ///< metal time, s
    std::uint64_t bytes = 0; ///< size of the file
    size_t redone = 0;       ///< times that the attempt went back; not 0 means practice
    bool forScore = false;   ///< true: the attempt was a test
};

/// Reads head and end. Without an end, as in an attempt that is running or was killed, it follows the frame lengths
/// through the file. Checks the hash of the head alone. Throws as readRecording() does, and if the head is not whole.
RecordingSummary readRecordingSummary(const std::filesystem::path& file);

/// Start of the attempt, by which attempts are sorted: the head's UTC time; in an older head its local date and its
/// distance from UTC; else the time `file` was last written, but never later than now.
Moment beginOf(const AttemptHead& head, const std::filesystem::path& file);

/// Start of the attempt, from the head in the file; without a whole head, the time the file was last written. Never
/// throws for the contents of the file.
Moment beginOf(const std::filesystem::path& file);

/// Hash of a file's bytes as 16 hexadecimal digits; empty if it cannot be read.
std::string fileHash(const std::filesystem::path& file);

/// "7 s", "1 min 7 s"
std::string durationText(double seconds);

} // namespace meltpool
