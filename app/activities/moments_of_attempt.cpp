#include "app/activities/moments_of_attempt.hpp"

#include "core/training/attempt/recording_reader.hpp"
#include "core/training/judging/judgement.hpp"

#include <optional>
#include <utility>

namespace meltpool {

namespace {

/// Who made them, where that is another one than here; empty where it is not.
std::string otherMaker(const RecordedAttempt& attempt, const Lesson& lesson, const ReplayMachine& machine) {
    if (attempt.head.driver != machine.driver) return "another driver, " + attempt.head.driver;
    if (attempt.head.program != machine.program) return "another version, " + attempt.head.program;
    if (!attempt.head.lessonHash.empty() && attempt.head.lessonHash != fileHash(lesson.file))
        return "another version of its lesson";
    return {};
}

} // namespace

MomentsOfAttempt momentsOfAttempt(const Lesson& lesson, const ReplayMachine& machine) {
    if (!lesson.recorded || !lesson.recorded->framed) return {};
    const Recording recording = readSoundRecording(lesson.recorded->file);
    if (recording.checkpoints.empty()) return {};
    const std::string other = otherMaker(*lesson.recorded, lesson, machine);
    if (!other.empty())
        return {nullptr, "The moments in the recording were made with " + other +
                             ": they are not used, and the way to another moment begins at the start."};
    std::optional<Technique> technique;
    if (lesson.model == LessonModel::Weld)
        technique.emplace(techniqueOf(lesson.workpiece, lesson.process, lesson.technique));
    return {std::make_unique<RecordedMoments>(recording, std::move(technique)), {}};
}

} // namespace meltpool
