#include "app/activities/attempt_lesson.hpp"

#include "core/base/error.hpp"
#include "core/training/lesson/lesson_folders.hpp"

namespace meltpool {

Lesson lessonOfAttempt(const std::filesystem::path& file, const std::string& lesson) {
    const LessonFolders folders = LessonFolders::ofUser();
    Lesson found;
    if (lesson.empty()) {
        const auto attempt = readRecordedAttempt(file);
        if (!attempt)
            throw InputError(file, 0, "names no lesson; expected a recorded attempt, or --lesson with a torch path");
        found = findLessonOf(*attempt, folders);
    } else {
        found = findLesson(lesson, folders);
    }
    takeTorch(found, file);
    return found;
}

} // namespace meltpool
