// What a recording holds: all that repeats an attempt to the same bits, and shows it from the person's own eyes.
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

/// How the name of a recording ends.
inline constexpr std::string_view kRecordingEnding = ".meltrec";

/// A step of the metal.
struct RecordingStep {
    std::uint64_t steps = 0; ///< made so far, with this one
    TorchSample torch;       ///< its time is that of the step's end
    ArcState arc;
    double realTime = 1; ///< simulated over real time about this step
};

/// In the workpiece's frame, m; it looks along its -Z.
struct RecordingPose {
    glm::vec3 position{0.0f};
    glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};
    bool operator==(const RecordingPose&) const = default;
};

/// Head and hands of the person between two steps.
struct RecordingPerson {
    std::uint64_t steps = 0;           ///< made before
    std::optional<RecordingPose> head; ///< between the eyes
    std::optional<RecordingPose> left; ///< what the left hand holds
    std::optional<RecordingPose> right;
    float zoom = 1; ///< size at which the workpiece is shown, 1 is real
};

/// A value that changed or an event between two steps.
struct RecordingNote {
    std::uint64_t steps = 0; ///< made before
    double seconds = 0;      ///< of the metal's time
    size_t frame = 0;        ///< where it stands in the file, see RecordingFrame::number
    std::string name;
    std::string value;
};

/// The state of everything after a step; readCheckpoint() answers its bytes.
struct RecordingCheckpoint {
    std::uint64_t steps = 0;
    std::uint64_t offset = 0; ///< of its bytes in the file
    std::uint64_t size = 0;   ///< bytes
};

/// How an attempt ended.
struct RecordingEnd {
    std::string reason;
    std::string stateHash;       ///< of the metal, 16 hexadecimal digits
    std::uint64_t steps = 0;     ///< made in all
    double seconds = 0;          ///< of the metal's time
    double realTime = 1;         ///< simulated over real time, of all steps together
    double leastRealTime = 1;    ///< of the slowest step
    std::optional<double> score; ///< 0..100, of the last judgement where it is of the finished weld
    std::string verdict;         ///< "accepted" or "not accepted"; empty: none
    size_t redone = 0;           ///< times that the attempt went back: practice, where it is not 0
};

/// Where a file stops being whole.
struct RecordingFault {
    bool cut = false;       ///< the file ends inside of a frame; else what stands there is not what was written
    size_t frame = 0;       ///< number of the frame, from 1
    std::uint64_t byte = 0; ///< where it begins
};

/// All whole frames of a file, up to the first fault. Where the attempt went back, event `redo`, and on to another end,
/// what came after that step is left out: steps, people, changes, checkpoints, and events of the torch and the arc.
struct Recording {
    std::filesystem::path file;
    AttemptHead head;
    std::vector<RecordingStep> steps;
    std::vector<RecordingPerson> people;
    std::vector<RecordingNote> changes;           ///< in the order of the steps
    std::vector<RecordingNote> events;            ///< the same
    std::vector<RecordingCheckpoint> checkpoints; ///< in the order of the steps
    size_t redone = 0;                            ///< times that it went back
    std::optional<RecordingEnd> end;              ///< nothing where the program ended without warning
    size_t frames = 0;                            ///< that are whole
    std::optional<RecordingFault> fault;

    /// Of the metal's time that are whole, s.
    double seconds() const { return steps.empty() ? 0 : steps.back().torch.time; }
    bool damaged() const { return fault && !fault->cut; }
    /// Whether it is whole, cut short or damaged, and how much of it is whole.
    std::string stateSentence() const;
};

} // namespace meltpool
