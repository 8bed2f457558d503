// `meltpool recordings`: what the program has kept of people's attempts.
#include "app/commands/commands.hpp"
#include "app/session/recordings/kept_attempts.hpp"
#include "app/session/recordings/recordings_limit.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/recording/recording_csv.hpp"
#include "core/training/recording/recording_reader.hpp"

#include <algorithm>
#include <cstdio>

namespace meltpool {

namespace {

constexpr size_t kMostBytes = 1000; ///< of a text that a file brings

std::string shown(const std::string& text) {
    return printable(text, kMostBytes);
}

bool check(const std::filesystem::path& file) {
    const Recording recording = readRecording(file);
    std::printf("%s: %s.\n", shown(file.string()).c_str(), shown(recording.stateSentence()).c_str());
    return !recording.damaged();
}

bool writeTable(const std::filesystem::path& file, const std::filesystem::path& table) {
    std::error_code missing;
    if (std::filesystem::equivalent(file, table, missing))
        throw InputError(table, 0, "is the recording itself; expected another name for the table");
    const Recording recording = readRecording(file);
    if (recording.steps.empty())
        throw InputError(file, 0, "holds no whole step; expected an attempt in which something was done");
    writeTextFileAtomically(table, recordingCsv(recording));
    std::printf("The table is %s; %s.\n", shown(table.string()).c_str(), shown(recording.stateSentence()).c_str());
    return !recording.damaged();
}

void printAttempt(const KeptAttempt& kept) {
    const std::string score = kept.score ? std::to_string(*kept.score) : "-";
    std::printf("%-16s  %-20s %12s %5s %-12s %9.1f MB  %s\n", shown(kept.when).c_str(), shown(kept.lesson).c_str(),
                durationText(kept.seconds).c_str(), score.c_str(),
                shown(kept.practice ? "practice" : kept.verdict).c_str(), static_cast<double>(kept.bytes) * 1e-6,
                shown(kept.file.filename().string()).c_str());
}

/// How many recordings a folder has lost to its limit.
size_t removedCount(const std::filesystem::path& folder) {
    try {
        const std::string text = readTextFile(folder / kRemovedList);
        return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
    } catch (const InputError&) {
        return 0; // there is none
    }
}

void list(const std::filesystem::path& folder) {
    std::vector<std::string> faults;
    const std::vector<KeptAttempt> attempts = keptRecordings(folder, &faults);
    if (attempts.empty()) {
        std::printf("There are no recordings in %s.\n", shown(folder.string()).c_str());
    } else {
        std::printf("%-16s  %-20s %12s %5s %-12s %12s  %s\n", "begun", "lesson", "length", "score", "verdict", "size",
                    "file");
        for (const KeptAttempt& kept : attempts)
            printAttempt(kept);
        std::printf("They are in %s and take %.1f MB.\n", shown(folder.string()).c_str(),
                    static_cast<double>(recordedBytes(folder)) * 1e-6);
    }
    if (const size_t removed = removedCount(folder); removed > 0)
        std::printf("%zu older ones were removed, as all together are limited; %s names them.\n", removed,
                    shown((folder / kRemovedList).string()).c_str());
    for (const std::string& fault : faults)
        std::printf("%s\n", shown(fault).c_str());
}

} // namespace

bool runRecordings(const RecordingsRequest& request) {
    if (!request.checked.empty()) return check(request.checked);
    if (!request.table.empty()) return writeTable(request.table.at(0), request.table.at(1));
    const std::filesystem::path folder = request.folder.empty() ? recordingsFolder() : request.folder;
    if (!request.folder.empty() && !std::filesystem::is_directory(folder))
        throw InputError(folder, 0, "is no folder; expected one of recordings");
    list(folder);
    return true;
}

} // namespace meltpool
