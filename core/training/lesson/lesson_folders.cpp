#include "core/training/lesson/lesson_folders.hpp"

#include "core/base/environment.hpp"
#include "core/base/error.hpp"
#include "core/base/likely_name.hpp"
#include "core/base/output_file.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/toml_table.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSchoolVariable = "MELTPOOL_LESSONS";

bool isLessonName(const fs::path& file) {
    const std::string extension = lowerExtension(file);
    return extension == ".toml" || extension == ".meltpool";
}

/// A TOML file for other readers: torch path, material, acceptance limits, or a check of another lesson.
bool isForOtherReaders(const fs::path& file) {
    try {
        const toml::table root = parseTomlFile(file);
        const auto has = [&](std::string_view key) { return root.contains(key); };
        if (has("model") || has("workpiece") || has("title")) return false;
        return has("move") || has("melting") || has("item") || (has("lesson") && has("expect"));
    } catch (const InputError&) {
        return false; // its fault must appear in the list of lessons
    }
}

/// The lesson files of one folder in the order of their names, .meltpool before .toml.
std::vector<fs::path> filesIn(const fs::path& folder, const std::string& expected) {
    std::vector<fs::path> files;
    std::error_code failure;
    for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
        if (isLessonName(entry->path())) files.push_back(entry->path());
    if (failure) throw InputError(folder, 0, "cannot be read; expected " + expected);
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return std::pair(a.stem(), a.extension()) < std::pair(b.stem(), b.extension());
    });
    return files;
}

std::string expectedFolder(LessonOrigin origin) {
    if (origin == LessonOrigin::school) return std::string("a folder with lessons (") + kSchoolVariable + " names it)";
    return "the folder of lessons";
}

/// Gives a lesson its fault if its name is one of `earlier`.
void tellNamesake(NamedLesson& lesson, const std::vector<NamedLesson>& earlier) {
    const auto first =
        std::find_if(earlier.begin(), earlier.end(), [&](const NamedLesson& each) { return each.key == lesson.key; });
    if (first == earlier.end()) return;
    const std::string meant = first->origin == LessonOrigin::shipped  ? "a shipped lesson"
                              : first->origin == LessonOrigin::school ? "a lesson of the school"
                                                                      : "another lesson in its folder";
    lesson.fault = InputError(lesson.file, 0,
                              "has the name of " + meant + ", so '" + lesson.key +
                                  "' means that one; expected a file name of its own, such as my-" + lesson.key +
                                  lesson.file.extension().string())
                       .what();
}

} // namespace

std::string_view nameOf(LessonOrigin origin) {
    constexpr std::array<std::string_view, 3> kNames{"shipped", "school", "own"};
    return kNames[static_cast<size_t>(origin)];
}

std::string_view headingOf(LessonOrigin origin) {
    constexpr std::array<std::string_view, 3> kHeadings{"library.origin.shipped", "library.origin.school",
                                                        "library.origin.own"};
    return phrase(kHeadings[static_cast<size_t>(origin)]);
}

LessonFolders::LessonFolders(const fs::path& shipped) : folders_{{LessonOrigin::shipped, shipped}} {}

LessonFolders LessonFolders::ofUser() {
    LessonFolders folders(resourceFolder() / "data" / "lessons");
    if (const std::string school = environmentVariable(kSchoolVariable); !school.empty())
        folders.add(LessonOrigin::school, school);
    folders.add(LessonOrigin::own, ownLessonsFolder());
    return folders;
}

void LessonFolders::add(LessonOrigin origin, const fs::path& folder) {
    std::error_code missing;
    for (const LessonFolder& each : folders_)
        if (fs::equivalent(each.path, folder, missing)) return;
    folders_.push_back({origin, folder});
}

std::vector<NamedLesson> LessonFolders::list(std::vector<std::string>* faults) const {
    std::vector<NamedLesson> lessons;
    for (const auto& [origin, folder] : folders_) {
        std::error_code failure;
        if (origin == LessonOrigin::own && !fs::exists(folder, failure) && !failure) continue;
        std::vector<fs::path> files;
        try {
            files = filesIn(folder, expectedFolder(origin));
        } catch (const InputError& fault) {
            if (origin == LessonOrigin::shipped) throw;
            if (faults != nullptr) faults->emplace_back(fault.what());
        }
        for (const fs::path& file : files) {
            NamedLesson lesson{file.stem().string(), file, origin};
            tellNamesake(lesson, lessons);
            if (!isPlainFile(file)) // reading a pipe would wait for its writer
                lesson.fault = InputError(file, 0, "is not a text file; expected a lesson").what();
            else if (origin != LessonOrigin::shipped && isForOtherReaders(file))
                continue;
            lessons.push_back(std::move(lesson));
        }
    }
    return lessons;
}

std::vector<NamedLesson> LessonFolders::named(const std::string& key) const {
    std::vector<NamedLesson> found;
    if (key.empty() || fs::path(key).has_parent_path()) return found; // a name must not lead into another folder
    for (const auto& [origin, folder] : folders_) {
        std::error_code failure;
        for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
            if (!isLessonName(entry->path()) || entry->path().stem().string() != key) continue;
            found.push_back({key, entry->path(), origin});
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const NamedLesson& a, const NamedLesson& b) {
        return std::pair(a.origin, a.file) < std::pair(b.origin, b.file);
    });
    for (size_t i = 1; i < found.size(); ++i)
        tellNamesake(found[i], found);
    return found;
}

fs::path ownLessonsFolder() {
    return ownFilesFolder() / "lessons";
}

Lesson findLesson(const std::string& name, const LessonFolders& folders) {
    if (isLessonName(name)) return readLesson(name);
    if (const std::vector<NamedLesson> found = folders.named(name); !found.empty()) return readLesson(found[0].file);
    std::vector<std::string> known, faults;
    for (const NamedLesson& each : folders.list(&faults))
        if (each.fault.empty()) known.push_back(each.key);
    std::string unread;
    for (const std::string& fault : faults)
        unread += "; " + fault;
    throw InputError("lesson " + quote(name) + " is not in the catalogue" + expectedNames(name, known) +
                     ", or a file that ends in .toml or .meltpool" + unread);
}

Lesson findLesson(const std::string& name, const fs::path& folder) {
    return findLesson(name, LessonFolders(folder));
}

Lesson findLessonOf(const RecordedAttempt& attempt, const LessonFolders& folders) {
    std::error_code failed;
    if (!attempt.head.lessonFile.empty() && fs::exists(attempt.head.lessonFile, failed))
        return readLesson(attempt.head.lessonFile);
    const std::vector<NamedLesson> found = folders.named(attempt.head.lesson);
    if (found.empty() || (!attempt.head.lessonFile.empty() && found[0].origin == LessonOrigin::shipped))
        throw InputError(attempt.file, 0,
                         "is of lesson " + quote(attempt.head.lesson) +
                             ", which is not in the catalogue; expected --lesson with this lesson's file");
    return readLesson(found[0].file);
}

std::string movedLessonText(const RecordedAttempt& attempt, const Lesson& lesson) {
    std::error_code failed;
    if (attempt.head.lessonFile.empty() || fs::exists(attempt.head.lessonFile, failed)) return {};
    return "The lesson's file " + printable(attempt.head.lessonFile, 500) + " is no longer there; the program uses " +
           printable(lesson.file.string(), 500) + ", which has the same name.";
}

} // namespace meltpool
