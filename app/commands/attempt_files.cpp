#include "app/commands/attempt_files.hpp"

#include "app/commands/named_lesson.hpp"
#include "core/base/error.hpp"
#include "core/base/likely_name.hpp"
#include "core/base/text.hpp"

#include <cstdio>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

ParameterList viewParameters(Lesson& lesson) {
    ParameterList list = describe(lesson.camera);
    for (ParameterList more : {describe(lesson.look), describe(lesson.surface)})
        list.insert(list.end(), more.begin(), more.end());
    return list;
}

} // namespace

Lesson openAttempt(const fs::path& file, const std::string& lesson) {
    std::error_code failed;
    if (fs::is_directory(file, failed))
        throw InputError(file, 0, "is a folder; expected the file of an attempt, such as telemetry.csv in it");
    const auto attempt = readRecordedAttempt(file);
    if (!attempt)
        throw InputError(file, 0,
                         "is no recorded attempt; expected a record that the trainer or a run has written (a plain "
                         "torch path is welded by 'meltpool run LESSON --torch')");
    const LessonFolders folders = LessonFolders::ofUser();
    Lesson made = lesson.empty() ? findLessonOf(*attempt, folders) : namedLesson(lesson, folders);
    if (const std::string moved = lesson.empty() ? movedLessonText(*attempt, made) : std::string(); !moved.empty())
        std::fprintf(stderr, "meltpool: %s\n", moved.c_str());
    takeTorch(made, file);
    if (!made.recorded || made.torch.empty())
        throw InputError(file, 0, "has no step of the torch; expected the record of an attempt");
    return made;
}

void setView(Lesson& lesson, std::span<const std::string> assignments) {
    for (const std::string& pair : assignments) {
        const size_t equals = pair.find('=');
        const std::string key = pair.substr(0, equals);
        const ParameterList list = viewParameters(lesson);
        if (equals == std::string::npos || findParameter(list, key) == nullptr) {
            std::vector<std::string> known;
            for (const Parameter& each : list)
                known.emplace_back(each.key);
            throw InputError("--view is " + quote(pair) +
                             expectedNames(key, known, "expected KEY=VALUE of what pictures show: "));
        }
        lesson.set(key, pair.substr(equals + 1), "--view " + printable(pair, 80));
    }
}

void setPictures(Lesson& lesson, const std::string& size, const std::string& every) {
    if (!every.empty()) lesson.set("pictures_every", every, "--pictures");
    if (size.empty()) return;
    const size_t cross = size.find('x');
    if (cross == std::string::npos)
        throw InputError("--size is " + quote(size) + "; expected WIDTHxHEIGHT in pixels, such as 1280x720");
    lesson.set("width", size.substr(0, cross), "--size " + size);
    lesson.set("height", size.substr(cross + 1), "--size " + size);
}

fs::path runFolderOf(const fs::path& path) {
    std::error_code failed;
    if (fs::is_directory(path, failed)) return path;
    if (path.filename() != "result.json") return {};
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

} // namespace meltpool
