#include "app/library/kept_attempts.hpp"

#include "app/library/attempt_title.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/training/attempt/recording_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

/// File with its moment: the local date that is shown gives no order, because zones and summer time change it.
struct Dated {
    Moment began;
    KeptAttempt attempt;
};

/// Date for people: "2026-11-23T08:10:43+0100" without the T, seconds and zone.
std::string whenText(std::string date) {
    std::replace(date.begin(), date.end(), 'T', ' ');
    return date.substr(0, 16);
}

Dated readKept(const fs::path& file) {
    const RecordingSummary summary = readRecordingSummary(file);
    KeptAttempt kept;
    kept.file = file;
    kept.lesson = summary.head.lesson;
    kept.lessonFile = summary.head.lessonFile;
    kept.when = whenText(summary.head.date);
    kept.seconds = summary.seconds;
    kept.person = summary.head.person;
    kept.personId = summary.head.personId;
    kept.bytes = summary.bytes;
    kept.practice = summary.redone > 0;
    kept.test = summary.forScore;
    kept.title = readTitle(file);
    if (summary.end) {
        if (summary.end->score) kept.score = static_cast<int>(std::lround(*summary.end->score));
        kept.verdict = summary.end->verdict;
        kept.ended = summary.end->reason;
    }
    return {beginOf(summary.head, file), std::move(kept)};
}

} // namespace

KeptAttempt readKeptAttempt(const fs::path& file) {
    return readKept(file).attempt;
}

fs::path recordingsFolder() {
    return keptFolder() / "recordings";
}

std::vector<KeptAttempt> keptRecordings(const fs::path& folder, std::vector<std::string>* faults) {
    std::vector<Dated> dated;
    std::error_code failure;
    for (const auto& entry : fs::directory_iterator(folder, failure)) {
        if (!isRecording(entry.path())) continue;
        try {
            dated.push_back(readKept(entry.path()));
        } catch (const InputError& fault) {
            if (faults != nullptr) faults->emplace_back(fault.what());
        }
    }
    std::sort(dated.begin(), dated.end(), [](const Dated& a, const Dated& b) {
        return std::pair(a.began, a.attempt.file) > std::pair(b.began, b.attempt.file);
    });
    std::vector<KeptAttempt> kept;
    kept.reserve(dated.size());
    for (Dated& each : dated)
        kept.push_back(std::move(each.attempt));
    return kept;
}

} // namespace meltpool
