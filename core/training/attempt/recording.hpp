// Defines the contents of a recording: all that repeats an attempt to the same bits, and shows it from the person's
// eyes.
#pragma once

#include "core/training/attempt/attempt_head.hpp"
#include "core/weld/process/arc.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// File name extension of a recording.
inline constexpr std::string_view kRecordingEnding = ".meltrec";

/// A step of the metal.
struct RecordingStep {
    std::uint64_t steps = 0; ///< steps made so far, including this one
    TorchSample torch;       ///< its time is the end of the step
    ArcState arc;
    double realTime = 1; ///< simulated time over real time, around this step
};

/// Pose in the workpiece's frame, m; it looks along its -Z.
struct RecordingPose {
    glm::vec3 position{0.0f};
    glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};
    bool operator==(const RecordingPose&) const = default;
};

/// Head and hands of the person between two steps.
struct RecordingPerson {
    std::uint64_t steps = 0;           ///< steps made before
    std::optional<RecordingPose> head; ///< between the eyes
    std::optional<RecordingPose> left; ///< tool in the left hand
    std::optional<RecordingPose> right;
    float zoom = 1; ///< scale of the shown workpiece, 1 is real
};

/// A value that changed or an event between two steps.
struct RecordingNote {
    std::uint64_t steps = 0; ///< steps made before
    double seconds = 0;      ///< metal time, s
    size_t frame = 0;        ///< number of its frame in the file, see RecordingFrame::number
    std::string name;
    std::string value;
};

/// State of everything after a step; readCheckpoint() returns its bytes.
struct RecordingCheckpoint {
    std::uint64_t steps = 0;
    std::uint64_t offset = 0; ///< offset of its bytes in the file
    std::uint64_t size = 0;   ///< size in bytes
};

/// End of an attempt.
struct RecordingEnd {
    std::string reason;
    std::string stateHash;       ///< hash of the metal's state, 16 hexadecimal digits
    std::uint64_t steps = 0;     ///< steps of the whole attempt
    double seconds = 0;          ///< metal time, s
    double realTime = 1;         ///< simulated time over real time, of all steps together
    double leastRealTime = 1;    ///< simulated time over real time, of the slowest step
    std::optional<double> score; ///< 0..100, of the last judgement, if it is of the finished weld
    std::string verdict;         ///< "accepted" or "not accepted"; empty: not judged
    size_t redone = 0;           ///< times that the attempt went back; not 0 means practice
};

/// Place where a file stops being whole.
struct RecordingFault {
    bool cut = false;       ///< true: the file ends inside a frame; false: its bytes differ from the written ones
    size_t frame = 0;       ///< number of the frame, from 1
    std::uint64_t byte = 0; ///< offset of the frame's first byte
};

/// All whole frames of a file, up to the first fault. After going back (event `redo`) and on to another end, everything
/// after that step is left out: steps, people, changes, checkpoints, and events of the torch and the arc.
struct Recording {
    std::filesystem::path file;
    AttemptHead head;
    std::vector<RecordingStep> steps;
    std::vector<RecordingPerson> people;
    std::vector<RecordingNote> changes;           ///< sorted by step
    std::vector<RecordingNote> events;            ///< sorted by step
    std::vector<RecordingCheckpoint> checkpoints; ///< sorted by step
    size_t redone = 0;                            ///< times that the attempt went back
    std::optional<RecordingEnd> end;              ///< empty if the program ended without warning
    size_t frames = 0;                            ///< number of whole frames
    std::optional<RecordingFault> fault;

    /// Metal time of the whole frames, s.
    double seconds() const { return steps.empty() ? 0 : steps.back().torch.time; }
    bool damaged() const { return fault && !fault->cut; }
    /// Sentence that says if it is whole, cut short or damaged, and how much of it is whole.
    std::string stateSentence() const;
};

} // namespace meltpool
