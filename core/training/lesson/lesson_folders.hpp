// Where lessons are found by name: the program's own, those of a school and those of the person.
#pragma once

#include "core/training/lesson/lesson.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// In the order in which lists show them. Of two lessons with one name the first is meant.
enum class LessonOrigin { shipped, school, own };

/// "shipped", "school", "own".
std::string_view nameOf(LessonOrigin origin);
/// The heading of such lessons: "School lessons".
std::string_view headingOf(LessonOrigin origin);

struct LessonFolder {
    LessonOrigin origin;
    std::filesystem::path path;
};

/// A lesson's file in one of the folders.
struct NamedLesson {
    std::string key; ///< the file's name without its ending
    std::filesystem::path file;
    LessonOrigin origin = LessonOrigin::shipped;
    /// Why the file cannot be used under its name, a sentence that begins with the file; empty: it can.
    std::string fault = {};
};

class LessonFolders {
  public:
    /// Only the lessons of this folder, as shipped ones.
    LessonFolders(const std::filesystem::path& shipped); // NOLINT: callers without others give the folder alone

    /// The program's lessons, those of the folder that MELTPOOL_LESSONS names, and those in ownLessonsFolder(). Throws
    /// as resourceFolder().
    static LessonFolders ofUser();

    /// Adds a folder behind the others, unless it is one of them. It need not exist.
    void add(LessonOrigin origin, const std::filesystem::path& folder);

    const std::vector<LessonFolder>& folders() const { return folders_; }

    /// The lessons' files, folder by folder in alphabetical order. Files beside a school's or a person's lessons that
    /// are materials, torch paths, acceptance limits or checks are left out. `faults` gets a sentence for each folder
    /// of a school or a person that cannot be read; a person's folder that is missing is none. Throws InputError where
    /// the shipped lessons cannot be read.
    std::vector<NamedLesson> list(std::vector<std::string>* faults = nullptr) const;

    /// The files of this name: the first is the lesson that the name means, each other one has its fault.
    std::vector<NamedLesson> named(const std::string& key) const;

  private:
    std::vector<LessonFolder> folders_;
};

/// findLesson() in all of the folders: a file where the name ends in ".toml" or ".meltpool", else the lesson that the
/// name means. Throws InputError, listing what there is, for an unknown name.
Lesson findLesson(const std::string& name, const LessonFolders& folders);

/// The lesson that an attempt names: of a recording the file where it is still there, else the lesson of that name in
/// the folders; a name of a shipped lesson takes no other file's place. Throws InputError where there is none, and what
/// readLesson() throws.
Lesson findLessonOf(const RecordedAttempt& attempt, const LessonFolders& folders);

/// A sentence where findLessonOf() found another file than the one that the attempt names; else empty.
std::string movedLessonText(const RecordedAttempt& attempt, const Lesson& lesson);

/// The person's own lessons ($XDG_DATA_HOME/meltpool/lessons, ~/.local/share/meltpool/lessons,
/// %APPDATA%\meltpool\lessons). Does not create it.
std::filesystem::path ownLessonsFolder();

} // namespace meltpool
