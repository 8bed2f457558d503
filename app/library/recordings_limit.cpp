#include "app/library/recordings_limit.hpp"

#include "app/library/attempt_title.hpp"
#include "app/library/deleted_attempts.hpp"
#include "core/base/words.hpp"
#include "core/training/attempt/recording_reader.hpp"

#include <algorithm>
#include <fstream>
#include <tuple>
#include <vector>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

constexpr double kNear = 0.9;         ///< share of the limit from which on it is reported
constexpr size_t kLongestLesson = 60; ///< characters of a lesson's key in a name
constexpr std::string_view kDate = "0000-00-00_00-00-00_";

struct File {
    fs::path path;
    std::uint64_t bytes = 0;
    bool kept = true;  ///< false: a person has deleted it
    Moment began = {}; ///< set by removable()
};

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// True if recordingName() has made this name.
bool isOwnName(const fs::path& file) {
    const std::string name = file.filename().string();
    if (!isRecording(file) || name.size() <= kDate.size()) return false;
    for (size_t i = 0; i < kDate.size(); ++i)
        if (isDigit(kDate[i]) ? !isDigit(name[i]) : name[i] != kDate[i]) return false;
    return true;
}

void addOwnFiles(std::vector<File>& files, const fs::path& folder, bool kept) {
    std::error_code failure;
    for (const auto& entry : fs::directory_iterator(folder, failure)) {
        if (!isOwnName(entry.path())) continue;
        const std::uint64_t bytes = fs::file_size(entry.path(), failure);
        if (!failure) files.push_back({entry.path(), bytes, kept});
    }
}

std::vector<File> ownFiles(const fs::path& folder) {
    std::vector<File> files;
    addOwnFiles(files, folder, true);
    addOwnFiles(files, folder / kDeletedFolder, false);
    return files;
}

/// Files that may be removed, deleted ones first, then the oldest. Reads the head of each.
std::vector<File> removable(std::vector<File> files, std::span<const fs::path> spared) {
    std::erase_if(files,
                  [&](const File& file) { return std::find(spared.begin(), spared.end(), file.path) != spared.end(); });
    for (File& file : files)
        file.began = beginOf(file.path);
    std::sort(files.begin(), files.end(), [](const File& a, const File& b) {
        return std::tie(a.kept, a.began, a.path) < std::tie(b.kept, b.began, b.path);
    });
    return files;
}

std::uint64_t sum(const std::vector<File>& files) {
    std::uint64_t bytes = 0;
    for (const File& file : files)
        bytes += file.bytes;
    return bytes;
}

std::string megabytes(std::uint64_t bytes) {
    return std::to_string((bytes + 500'000) / 1'000'000);
}

std::string stem(const File& file) {
    return file.path.stem().string();
}

} // namespace

ParameterList describe(RecordingParameters& r) {
    return {{"keep_recordings", "Record every attempt", "", &r.keep, 0, 1,
             "From the next attempt on. A recording replays the attempt. It takes up to 60 MB a minute."},
            {"recordings_limit_mb", "Recordings, at most", "MB", &r.limitMb, 50, 1'000'000,
             "Space on the disk. Beyond it the oldest recordings are removed, with a message."}};
}

fs::path recordingName(const fs::path& folder, const std::string& date, const std::string& lesson, int attempt) {
    std::string name = date.substr(0, 19);
    std::replace(name.begin(), name.end(), 'T', '_');
    std::replace(name.begin(), name.end(), ':', '-');
    name += '_';
    for (const char c : lesson.substr(0, kLongestLesson)) {
        const bool plain = isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
        name += plain ? c : '_';
    }
    name += "_" + std::to_string(attempt);
    std::error_code failure;
    fs::path file = folder / (name + std::string(kRecordingEnding));
    for (int number = 2; fs::exists(fs::symlink_status(file, failure)); ++number) // two programs in one second
        file = folder / (name + "-" + std::to_string(number) + std::string(kRecordingEnding));
    return file;
}

std::uint64_t recordedBytes(const fs::path& folder) {
    return sum(ownFiles(folder));
}

std::string keepWithinLimit(const fs::path& folder, std::uint64_t limit, std::span<const fs::path> spared) {
    const std::vector<File> all = ownFiles(folder);
    std::uint64_t bytes = sum(all);
    if (bytes <= limit) return {};
    const std::vector<File> files = removable(all, spared);
    std::vector<const File*> removed;
    for (size_t i = 0; i < files.size() && bytes > limit; ++i) {
        std::error_code failure;
        const bool ours = fs::remove(files[i].path, failure);
        if (failure) continue;
        bytes -= files[i].bytes;
        fs::remove(titleFile(files[i].path), failure);
        if (ours) removed.push_back(&files[i]); // otherwise another program has removed it
    }
    if (removed.empty()) return {};
    std::ofstream list(folder / kRemovedList, std::ios::app);
    for (const File* file : removed)
        list << file->path.filename().string() << "\n";
    return phraseOfCount("library.recordings.removed", static_cast<long long>(removed.size()),
                         {{"limit", megabytes(limit)},
                          {"count", std::to_string(removed.size())},
                          {"first", stem(*removed.front())},
                          {"last", stem(*removed.back())}});
}

std::string nearLimit(const fs::path& folder, std::uint64_t limit, std::span<const fs::path> spared) {
    const std::vector<File> all = ownFiles(folder);
    const std::uint64_t bytes = sum(all);
    if (all.empty() || static_cast<double>(bytes) < kNear * static_cast<double>(limit)) return {};
    const std::string taken =
        phrase("library.recordings.taken", {{"megabytes", megabytes(bytes)}, {"limit", megabytes(limit)}});
    const std::vector<File> files = removable(all, spared);
    if (files.empty()) return taken + " " + phrase("library.recordings.none_removable");
    return taken + " " + phrase("library.recordings.first_removed", {{"first", stem(files.front())}});
}

} // namespace meltpool
