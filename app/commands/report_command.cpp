// `meltpool report`: the results of runs and records as pages for people.
#include "app/commands/commands.hpp"
#include "app/commands/named_lesson.hpp"
#include "app/commands/run_folder.hpp"
#include "app/platform/say.hpp"
#include "app/report/record_results.hpp"
#include "app/report/report_page.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/words.hpp"

#include <cstdio>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

/// True for a folder of a run or its result.json; any other file is taken for a record.
bool isRun(const fs::path& source) {
    std::error_code failed;
    return fs::is_directory(source, failed) || source.extension() == ".json" || !fs::exists(source, failed);
}

RunResults resultsIn(const fs::path& source, const std::string& lesson) {
    if (isRun(source)) return readRunResults(source);
    const auto attempt = readRecordedAttempt(source);
    if (!attempt)
        throw InputError(source, 1,
                         "is not the record of an attempt; expected a record, the folder of a run, or its result.json");
    const LessonFolders folders = LessonFolders::ofUser();
    if (!lesson.empty()) return readRecordResults(source, namedLesson(lesson, folders));
    const Lesson own = findLessonOf(*attempt, folders);
    if (const std::string moved = movedLessonText(*attempt, own); !moved.empty())
        std::fprintf(stderr, "meltpool: %s\n", moved.c_str());
    return readRecordResults(source, own);
}

/// Path of the page: in a run's folder, or next to a record under its name.
fs::path pageOf(const fs::path& source) {
    std::error_code failed;
    if (fs::is_directory(source, failed)) return source / "report.html";
    if (isRun(source)) return source.parent_path() / "report.html";
    fs::path page = source;
    return page.replace_extension(".html");
}

/// Throws if a page would replace its own source.
void requireNoSource(const fs::path& page, const fs::path& source) {
    std::error_code failed;
    const fs::path folder = fs::is_directory(source, failed) ? source : source.parent_path();
    const bool beside =
        fs::equivalent(folder.empty() ? "." : folder, page.has_parent_path() ? page.parent_path() : ".", failed);
    const std::string name = page.filename().string();
    if (fs::equivalent(page, source, failed) || (beside && isRunFile(name) && name != "report.html"))
        throw InputError(page, 0, "the page would be written over a file of the attempt; expected another name");
}

} // namespace

void writeReports(const ReportRequest& request) {
    if (request.sources.size() > 1 && !request.page.empty())
        throw InputError("--out names one page, but there are " + std::to_string(request.sources.size()) +
                         " results; expected one result, or no --out");
    for (const fs::path& source : request.sources) {
        const fs::path page = request.page.empty() ? pageOf(source) : request.page;
        requireNoSource(page, source);
        writeFile(page, reportPage(resultsIn(source, request.lesson)));
        sayResult(phrase("run.report", {{"file", page.string()}}), page);
    }
}

} // namespace meltpool
