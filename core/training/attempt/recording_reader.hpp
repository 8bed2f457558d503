// Reads recordings: all of one, or what a list of many shows.
#pragma once

#include "core/base/moment.hpp"
#include "core/training/attempt/recording.hpp"
#include "core/weld/torch/torch_path.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace meltpool {

/// The name ends as that of a recording.
bool isRecording(const std::filesystem::path& file);

/// All whole frames up to the end or the first fault, which is in the answer. Throws InputError for a file that cannot
/// be read or does not begin like a recording, and, naming frame and second, for a frame that is as it was written but
/// holds what no attempt has.
Recording readRecording(const std::filesystem::path& file);

/// The same of a recording that is to be used: throws InputError, naming frame and second, where it is damaged, and
/// where it holds no step. One that was cut short, as by a killed program, is used as far as it goes.
Recording readSoundRecording(const std::filesystem::path& file);

/// The torch of every step, to the bit.
TorchPath torchPathOf(const Recording& recording);

/// The bytes of a checkpoint that readRecording() found in the file. Throws InputError where they are no longer there.
std::vector<std::byte> readCheckpoint(const std::filesystem::path& file, const RecordingCheckpoint& checkpoint);

/// What can be told of a recording without reading all of it.
struct RecordingSummary {
    AttemptHead head;
    std::optional<RecordingEnd> end;
    double seconds = 0;      ///< of the metal's time
    std::uint64_t bytes = 0; ///< of the file
    size_t redone = 0;       ///< times that the attempt went back: practice, where it is not 0
};

/// Reads head and end; only where there is no end, as of an attempt that runs or was killed, the file is walked
/// through. Nothing is checked by hash but the head. Throws as readRecording() does, and where the head is not whole.
RecordingSummary readRecordingSummary(const std::filesystem::path& file);

/// When the attempt began, by which attempts are put in order: as the head says, in UTC; an older head by its local
/// date and that one's distance from UTC; else when `file` was last written, and at the latest now.
Moment beginOf(const AttemptHead& head, const std::filesystem::path& file);

/// The same of a file whose head is read for it; one without a whole head counts by when it was written. Never throws
/// for the contents of the file.
Moment beginOf(const std::filesystem::path& file);

/// Hash of a file's bytes as 16 hexadecimal digits; empty where it cannot be read.
std::string fileHash(const std::filesystem::path& file);

/// "7 s", "1 min 7 s"
std::string durationText(double seconds);

} // namespace meltpool
