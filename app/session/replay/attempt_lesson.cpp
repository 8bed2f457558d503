#include "app/session/replay/attempt_lesson.hpp"

#include "core/base/error.hpp"
#include "core/base/resources.hpp"

namespace meltpool {

Lesson lessonOfAttempt(const std::filesystem::path& file, const std::string& lesson) {
    std::string name = lesson;
    if (name.empty()) {
        const auto attempt = readRecordedAttempt(file);
        if (!attempt)
            throw InputError(file, 0, "names no lesson; expected a kept attempt, or --lesson beside a torch path");
        name = attempt->lessonFile.empty() ? attempt->lesson : attempt->lessonFile;
    }
    Lesson found = findLesson(name, resourceFolder() / "data" / "lessons");
    takeTorch(found, file);
    return found;
}

} // namespace meltpool
