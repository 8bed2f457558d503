// `meltpool compare`: two attempts side by side, each a recorded one or the folder of a run.
#include "app/commands/attempt_files.hpp"
#include "app/commands/attempt_welder.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/comparison_output.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <array>
#include <memory>
#include <optional>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

/// One of the two: the folder of a run, or an attempt that remains to be welded into its own folder.
struct Side {
    fs::path file;
    fs::path run; ///< folder of the run; empty for an attempt
    std::optional<Lesson> lesson;
    std::unique_ptr<RunFolder> folder; ///< a pointer, because a locked folder cannot move
};

Side openSide(const fs::path& file, const CompareRequest& request, const char* name) {
    Side side{file, runFolderOf(file), {}, {}};
    if (!side.run.empty()) return side;
    side.lesson = openAttempt(file, request.lesson);
    setPictures(*side.lesson, request.size, request.picturesEvery.empty() ? "0" : request.picturesEvery);
    side.folder = std::make_unique<RunFolder>(request.folder / name, lessonSources(*side.lesson));
    side.run = side.folder->path();
    return side;
}

/// Name of a side on the page: the file's name, with its folder's if both files have one name.
std::string nameOf(const fs::path& file, const fs::path& other) {
    const fs::path own = file.lexically_normal();
    const fs::path last = own.has_filename() ? own : own.parent_path();
    const std::string name = last.filename().string();
    const fs::path beside = other.lexically_normal();
    const bool alike = (beside.has_filename() ? beside : beside.parent_path()).filename() == last.filename();
    return alike && last.has_parent_path() ? (last.parent_path().filename() / name).string() : name;
}

/// Throws InputError if the two belong to different lessons, whose figures cannot be compared.
void requireSameLesson(const std::array<Side, 2>& sides) {
    std::array<std::string, 2> lessons;
    for (size_t i = 0; i < sides.size(); ++i)
        lessons[i] =
            sides[i].lesson ? sides[i].lesson->key : readRunResults(sides[i].run).result.value("lesson", std::string());
    if (lessons[0] != lessons[1])
        throw InputError(sides[1].file, 0,
                         "is of the lesson " + quote(lessons[1]) + ", and " + printable(sides[0].file.string(), 200) +
                             " of " + quote(lessons[0]) + "; expected two attempts at one lesson");
}

} // namespace

void compareAttemptFiles(const CompareRequest& request) {
    // Both are read before one is welded.
    std::array<Side, 2> sides{openSide(request.first, request, "first"), openSide(request.second, request, "second")};
    requireSameLesson(sides);
    std::optional<AttemptWelder> welder;
    for (Side& side : sides) {
        if (!side.lesson) continue;
        if (!welder) welder.emplace();
        welder->weld(*side.lesson, *side.folder);
    }
    std::error_code failed;
    fs::create_directories(request.folder, failed);
    if (failed)
        throw InputError(request.folder, 0, "cannot be created; expected a parent folder with write permission");
    const ComparedRun first{nameOf(request.first, request.second), readRunResults(sides[0].run)};
    const ComparedRun second{nameOf(request.second, request.first), readRunResults(sides[1].run)};
    tellComparison(first, second, request.folder, request.page);
}

} // namespace meltpool
