#include "app/activities/file_checkpoints.hpp"

#include "core/base/words.hpp"
#include "core/training/attempt/recording_reader.hpp"
#include "core/training/judging/judgement.hpp"

#include <optional>
#include <utility>

namespace meltpool {

namespace {

/// Sentence that says why checkpoints of another machine are not used; empty if they were made on this one.
std::string refusalOf(const RecordedAttempt& attempt, const Lesson& lesson, const ReplayMachine& machine) {
    if (attempt.head.driver != machine.driver)
        return phrase("attempt.moments.other_driver", {{"driver", attempt.head.driver}});
    if (attempt.head.program != machine.program)
        return phrase("attempt.moments.other_program", {{"program", attempt.head.program}});
    if (!attempt.head.lessonHash.empty() && attempt.head.lessonHash != fileHash(lesson.file))
        return phrase("attempt.moments.other_lesson");
    return {};
}

} // namespace

FileCheckpoints fileCheckpoints(const Lesson& lesson, const ReplayMachine& machine) {
    if (!lesson.recorded || !lesson.recorded->framed) return {};
    const Recording recording = readSoundRecording(lesson.recorded->file);
    if (recording.checkpoints.empty()) return {};
    std::string refusal = refusalOf(*lesson.recorded, lesson, machine);
    if (!refusal.empty()) return {nullptr, std::move(refusal)};
    std::optional<Technique> technique;
    if (lesson.model == LessonModel::Weld)
        technique.emplace(techniqueOf(lesson.workpiece, lesson.process, lesson.technique));
    return {std::make_unique<RecordedCheckpoints>(recording, std::move(technique)), {}};
}

} // namespace meltpool
