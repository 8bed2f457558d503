// Converts the content of a recording's frames to bytes and back.
#pragma once

#include "core/training/attempt/recording.hpp"

#include <array>
#include <string>
#include <string_view>

namespace meltpool {

/// The format that this program writes; a file of a later format is refused.
inline constexpr std::uint32_t kRecordingFormat = 1;

inline constexpr size_t kStepBytes = 160;
inline constexpr size_t kPersonBytes = 100;
/// Bytes before a note's name: steps and the name's length.
inline constexpr size_t kNoteHeadBytes = 12;

/// Heads and ends are text of lines `word value`, so that a later format can add words.
std::string headContent(const AttemptHead& head);
/// Ends with the length of its whole frame, so that a reader finds it from the file's end.
std::string endContent(const RecordingEnd& end);
std::array<char, kStepBytes> stepContent(const RecordingStep& step);
std::array<char, kPersonBytes> personContent(const RecordingPerson& person);
std::array<char, kNoteHeadBytes> noteHead(std::uint64_t steps, std::string_view name);

/// Each throws InputError, naming the content alone, if the content is too short or has a number that is not finite, a
/// quaternion that is not of unit length or an unknown word for an arc. Bytes behind the known ones are ignored.
AttemptHead readHead(std::string_view content);
RecordingEnd readEnd(std::string_view content);
RecordingStep readStep(std::string_view content);
RecordingPerson readPerson(std::string_view content);
RecordingNote readNote(std::string_view content);

/// Head before the bytes of a checkpoint.
struct CheckpointHead {
    std::uint64_t steps = 0;
    std::uint32_t redone = 0; ///< times that the attempt had gone back; the file may hold this checkpoint after a later
                              ///< time
};
inline constexpr size_t kCheckpointHeadBytes = 12;
std::array<char, kCheckpointHeadBytes> checkpointHead(const CheckpointHead& head);
CheckpointHead readCheckpointHead(std::string_view content);

} // namespace meltpool
