// `meltpool recordings`: the stored recordings of people's attempts.
#include "app/commands/commands.hpp"
#include "app/library/attempts_csv.hpp"
#include "app/library/kept_attempts.hpp"
#include "app/library/recordings_limit.hpp"
#include "app/library/replay_list.hpp"
#include "app/platform/say.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"
#include "core/training/attempt/recording_csv.hpp"
#include "core/training/attempt/recording_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace meltpool {

namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostBytes = 1000; ///< bytes of a text from a file

std::string shown(const std::string& text) {
    return printable(text, kMostBytes);
}

/// Reason of an attempt's end, in the chosen language: the recording has the English words.
std::string endText(const std::string& reason) {
    std::string key = "run.recordings.end." + reason;
    std::replace(key.begin(), key.end(), ' ', '_');
    return std::string(phraseOr(key, reason));
}

/// Recording::stateSentence() in the chosen language.
std::string stateText(const Recording& recording) {
    const PhraseNumber seconds(recording.seconds(), 2);
    const std::string frames = std::to_string(recording.frames);
    if (recording.fault)
        return phrase(recording.damaged() ? "run.recordings.whole.damaged" : "run.recordings.whole.cut",
                      {{"seconds", seconds},
                       {"frames", frames},
                       {"frame", std::to_string(recording.fault->frame)},
                       {"byte", std::to_string(recording.fault->byte)}});
    if (!recording.end) return phrase("run.recordings.whole.killed", {{"seconds", seconds}, {"frames", frames}});
    return phrase("run.recordings.whole.ended",
                  {{"seconds", seconds}, {"frames", frames}, {"reason", endText(recording.end->reason)}});
}

bool check(const std::filesystem::path& file) {
    const Recording recording = readRecording(file);
    std::printf("%s\n",
                phrase("run.recordings.state", {{"file", shown(file.string())}, {"state", shown(stateText(recording))}})
                    .c_str());
    return !recording.damaged();
}

bool writeTable(const std::filesystem::path& file, const std::filesystem::path& table) {
    std::error_code missing;
    if (std::filesystem::equivalent(file, table, missing))
        throw InputError(table, 0, "is the recording itself; expected another name for the table");
    const Recording recording = readRecording(file);
    if (recording.steps.empty())
        throw InputError(file, 0, "holds no whole step; expected an attempt with one step or more");
    writeTextFileAtomically(table, recordingCsv(recording));
    sayResult(
        phrase("run.recordings.table", {{"table", shown(table.string())}, {"state", shown(stateText(recording))}}),
        table);
    return !recording.damaged();
}

/// Verdict of an attempt, or the reason why it does not count.
std::string wordsOf(const KeptAttempt& kept) {
    if (kept.practice) return phrase("run.recordings.practice");
    const std::string verdict = verdictText(kept.verdict);
    if (!kept.test) return verdict;
    return verdict.empty() ? phrase("run.recordings.test_alone")
                           : phrase("run.recordings.test", {{"verdict", verdict}});
}

void printAttempt(const KeptAttempt& kept) {
    const std::string score = kept.score ? std::to_string(*kept.score) : "-";
    std::printf("%-16s  %-20s %12s %5s %-18s %9.1f MB  %s%s\n", shown(kept.when).c_str(), shown(kept.lesson).c_str(),
                durationText(kept.seconds).c_str(), score.c_str(), shown(wordsOf(kept)).c_str(),
                static_cast<double>(kept.bytes) * 1e-6, shown(kept.file.filename().string()).c_str(),
                kept.person.empty() ? "" : ("  " + shown(kept.person)).c_str());
}

/// Count of recordings that the limit removed from a folder.
size_t removedCount(const std::filesystem::path& folder) {
    try {
        const std::string text = readTextFile(folder / kRemovedList);
        return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
    } catch (const InputError&) {
        return 0; // the folder has no list
    }
}

/// Attempts of a folder in the program's order; their faults go to standard error.
std::vector<KeptAttempt> attemptsOf(const std::filesystem::path& folder) {
    std::vector<std::string> faults;
    std::vector<KeptAttempt> attempts = keptRecordings(folder, &faults);
    for (const std::string& fault : faults)
        std::fprintf(stderr, "meltpool: %s\n", shown(fault).c_str());
    return attempts;
}

void listAsJson(const std::filesystem::path& folder) {
    Json list = Json::array();
    for (const KeptAttempt& kept : attemptsOf(folder)) {
        Json attempt = Json::object();
        const auto row = attemptRow(kept);
        for (size_t i = 0; i < kAttemptColumns.size(); ++i)
            attempt[kAttemptColumns[i]] = row[i];
        list.push_back(std::move(attempt));
    }
    std::printf("%s\n", list.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

/// Writes one table of all attempts, a row each.
void tabulate(const std::filesystem::path& folder, const std::filesystem::path& table) {
    if (isRecording(table))
        throw InputError(table, 0,
                         "is a recording; expected a table's name after it, or a single name that ends in .csv");
    const std::vector<KeptAttempt> attempts = attemptsOf(folder);
    if (attempts.empty())
        say("%s\n", phrase("run.recordings.no_attempts", {{"folder", shown(folder.string())}}).c_str());
    writeTextFileAtomically(table, attemptsCsv(attempts));
    sayResult(phraseOfCount("run.recordings.table_of_attempts", static_cast<long long>(attempts.size()),
                            {{"attempts", std::to_string(attempts.size())}, {"table", shown(table.string())}}),
              table);
}

void list(const std::filesystem::path& folder) {
    std::vector<std::string> faults;
    const std::vector<KeptAttempt> attempts = keptRecordings(folder, &faults);
    if (attempts.empty()) {
        std::printf("%s\n", phrase("run.recordings.none", {{"folder", shown(folder.string())}}).c_str());
    } else {
        const auto column = [](std::string_view name) { return phraseOf("run.recordings.column", name).c_str(); };
        std::printf("%-16s  %-20s %12s %5s %-18s %12s  %s\n", column("begun"), column("lesson"), column("length"),
                    column("score"), column("verdict"), column("size"), column("file"));
        for (const KeptAttempt& kept : attempts)
            printAttempt(kept);
        const PhraseNumber megabytes(static_cast<double>(recordedBytes(folder)) * 1e-6, 1);
        std::printf(
            "%s\n",
            phrase("run.recordings.place", {{"folder", shown(folder.string())}, {"megabytes", megabytes}}).c_str());
    }
    if (const size_t removed = removedCount(folder); removed > 0)
        std::printf("%s\n", phraseOfCount("run.recordings.removed", static_cast<long long>(removed),
                                          {{"recordings", std::to_string(removed)},
                                           {"list", shown((folder / kRemovedList).string())}})
                                .c_str());
    for (const std::string& fault : faults)
        std::printf("%s\n", shown(fault).c_str());
}

} // namespace

bool runRecordings(const RecordingsRequest& request) {
    if (!request.checked.empty()) return check(request.checked);
    if (request.table.size() == 2) return writeTable(request.table[0], request.table[1]);
    const std::filesystem::path folder = request.folder.empty() ? recordingsFolder() : request.folder;
    if (!request.folder.empty() && !std::filesystem::is_directory(folder))
        throw InputError(folder, 0, "is not a folder; expected a folder of recordings");
    if (request.table.size() == 1)
        tabulate(folder, request.table[0]);
    else
        request.json ? listAsJson(folder) : list(folder);
    return true;
}

} // namespace meltpool
