// Finds lessons by name: the program's own, those of a school and those of the person.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Origins in the order of lists. Of two lessons with one name the first counts.
enum class LessonOrigin { shipped, school, own };

/// "shipped", "school", "own".
std::string_view nameOf(LessonOrigin origin);
/// Heading of such lessons in lists: "School lessons".
std::string_view headingOf(LessonOrigin origin);

struct LessonFolder {
    LessonOrigin origin;
    std::filesystem::path path;
};

/// A lesson's file in one of the folders.
struct NamedLesson {
    std::string key; ///< file name without its extension
    std::filesystem::path file;
    LessonOrigin origin = LessonOrigin::shipped;
    /// Reason why the file cannot be used under its name, a sentence that begins with the file; empty: usable.
    std::string fault = {};
};

class LessonFolders {
  public:
    /// Searches only this folder, as shipped lessons.
    LessonFolders(const std::filesystem::path& shipped); // NOLINT: callers without others give the folder alone

    /// The program's lessons, those of the folder that MELTPOOL_LESSONS names, and those in ownLessonsFolder(). Throws
    /// as resourceFolder().
    static LessonFolders ofUser();

    /// Adds a folder behind the others, unless it is already there. It need not exist.
    void add(LessonOrigin origin, const std::filesystem::path& folder);

    const std::vector<LessonFolder>& folders() const { return folders_; }

    /// The lesson files, folder by folder in alphabetical order. Materials, torch paths, acceptance limits and checks
    /// in the folders of a school or a person are left out. `faults` receives a sentence for each folder of a school or
    /// a person that cannot be read; a missing folder of a person is not a fault. Throws InputError if the shipped
    /// lessons cannot be read.
    std::vector<NamedLesson> list(std::vector<std::string>* faults = nullptr) const;

    /// The files of this name: the first is the lesson in use, each other one has its fault.
    std::vector<NamedLesson> named(const std::string& key) const;

  private:
    std::vector<LessonFolder> folders_;
};

/// findLesson() in all folders: a file if the name ends in ".toml" or ".meltpool", else the lesson in use under that
/// name. Throws InputError, listing the lessons, for an unknown name.
Lesson findLesson(const std::string& name, const LessonFolders& folders);

/// Finds the lesson of an attempt: for a recording its file if it still exists, else the lesson of that name in the
/// folders; the name of a shipped lesson never means another file. Throws InputError if there is none, and as
/// readLesson() does.
Lesson findLessonOf(const RecordedAttempt& attempt, const LessonFolders& folders);

/// A sentence if findLessonOf() found another file than the attempt's; else empty.
std::string movedLessonText(const RecordedAttempt& attempt, const Lesson& lesson);

/// Folder of the person's own lessons ($XDG_DATA_HOME/meltpool/lessons, ~/.local/share/meltpool/lessons,
/// %APPDATA%\meltpool\lessons). Does not create it.
std::filesystem::path ownLessonsFolder();

} // namespace meltpool
