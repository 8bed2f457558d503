// `meltpool demonstration`: turns an attempt that is worth showing into the path of a lesson.
#include "app/commands/attempt_files.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/demonstration_lesson.hpp"
#include "app/platform/say.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/weld/torch/torch_csv.hpp"

#include <algorithm>
#include <cstdio>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

/// Throws if `file` is one of the files that are read.
void requireNoSource(const fs::path& file, const Lesson& lesson) {
    for (const fs::path& source : lessonSources(lesson)) {
        std::error_code missing;
        if (fs::equivalent(source, file, missing))
            throw InputError(file, 0, "--out names a file that is read; expected another file");
    }
}

size_t changesAfter(const RecordedAttempt& attempt, double time, double duration) {
    const double step = duration / static_cast<double>(std::max<size_t>(attempt.rows, 1));
    return static_cast<size_t>(std::count_if(attempt.changes.begin(), attempt.changes.end(), [&](const auto& change) {
        return static_cast<double>(change.steps) * step >= time;
    }));
}

std::string shown(const fs::path& file) {
    return printable(file.string(), 1000);
}

} // namespace

void makeDemonstration(const DemonstrationRequest& request) {
    const bool whole = request.out.extension() == ".toml";
    if (!whole && request.out.extension() != ".csv")
        throw InputError(request.out, 0,
                         "is no name for a demonstration; expected one that ends in .csv (the torch path) or .toml (a "
                         "lesson, with its path beside it)");
    const Lesson lesson = openAttempt(request.file, request.lesson);
    const WeldedStretch stretch = weldedStretch(lesson);
    fs::path path = request.out;
    path.replace_extension(".csv");
    requireNoSource(path, lesson);
    requireNoSource(request.out, lesson);
    const std::string text = whole ? demonstrationLesson(lesson, stretch, path, request.out) : std::string();
    writeTorchCsv(path, {stretch.samples, {}, std::vector<std::vector<std::string>>(stretch.samples.size())});
    if (whole) writeTextFileAtomically(request.out, text);
    say("%s\n", phrase("run.demonstration.stretch", {{"file", shown(path)},
                                                     {"seconds", PhraseNumber(stretch.end - stretch.begin, 1)},
                                                     {"whole", PhraseNumber(lesson.torch.duration(), 1)},
                                                     {"begin", PhraseNumber(stretch.begin, 1)}})
                    .c_str());
    sayResult(whole ? phrase("run.demonstration.lesson", {{"file", shown(request.out)}}) : std::string(), request.out);
    if (const size_t later = changesAfter(*lesson.recorded, stretch.firstPull, lesson.torch.duration()); later > 0)
        say("%s\n", phraseOfCount("run.demonstration.later_values", static_cast<long long>(later),
                                  {{"values", std::to_string(later)}})
                        .c_str());
}

} // namespace meltpool
