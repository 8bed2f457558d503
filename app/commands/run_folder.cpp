#include "app/commands/run_folder.hpp"

#include "app/export/film.hpp"
#include "app/platform/lock_notice.hpp"
#include "core/base/error.hpp"
#include "core/base/files.hpp"
#include "core/base/text.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kLockName = "meltpool.lock";

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Name without the ".PROCESS.tmp" at its end that a killed process leaves.
std::string_view withoutDraftEnding(std::string_view name) {
    constexpr std::string_view kEnding = ".tmp";
    if (!name.ends_with(kEnding)) return name;
    const std::string_view rest = name.substr(0, name.size() - kEnding.size());
    const size_t dot = rest.rfind('.');
    if (dot == std::string_view::npos || dot + 1 == rest.size()) return name;
    return std::all_of(rest.begin() + static_cast<std::ptrdiff_t>(dot) + 1, rest.end(), isDigit) ? rest.substr(0, dot)
                                                                                                 : name;
}

/// Form "001.500s-metal.png", with as many digits before the point as the time has.
bool isPictureName(std::string_view name) {
    const size_t point = name.find('.');
    if (point == std::string_view::npos || point < 3 || name.size() < point + 10) return false;
    const auto digits = [name](size_t from, size_t count) {
        const std::string_view part = name.substr(from, count);
        return std::all_of(part.begin(), part.end(), isDigit);
    };
    return digits(0, point) && digits(point + 1, 3) && name.substr(point + 4, 2) == "s-" && name.ends_with(".png");
}

void makeFolder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure || !fs::is_directory(folder, failure))
        throw InputError(folder, 0, "cannot be created; expected a parent folder with write permission");
}

std::vector<fs::path> runFilesIn(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code failure;
    for (const fs::path& file : listFolder(folder, failure))
        if (isRunFile(file.filename().string())) found.push_back(file);
    if (failure) throw InputError(folder, 0, "cannot be read; expected a folder with read permission");
    return found;
}

} // namespace

fs::path newRunFolder(const fs::path& parent, const std::string& lessonKey) {
    const std::string name = "meltpool-" + lessonKey;
    fs::path folder = parent / name;
    std::error_code unknown; // a folder that cannot be inspected cannot be made either, which RunFolder reports
    for (int i = 2; fs::exists(folder, unknown); ++i)
        folder = parent / (name + "-" + std::to_string(i));
    return folder;
}

std::string removedText(const fs::path& folder, size_t files) {
    constexpr size_t kLongestShown = 1000;
    return phraseOfCount("run.removed", static_cast<long long>(files),
                         {{"folder", printable(folder.string(), kLongestShown)}, {"files", std::to_string(files)}});
}

bool isRunFile(std::string_view name) {
    const std::string_view base = withoutDraftEnding(name);
    return base == "result.json" || base == "telemetry.csv" || base == "technique.csv" || base == "weld.csv" ||
           base == "report.html" || isPictureName(base) || isFilmFile(base);
}

RunFolder::RunFolder(fs::path folder, std::span<const fs::path> sources) : folder_(std::move(folder)) {
    makeFolder(folder_);
    lock_.emplace(folder_ / kLockName, folder_);
    tellUnlocked(*lock_);
    for (const fs::path& file : runFilesIn(folder_))
        for (const fs::path& source : sources) {
            std::error_code missing;
            if (!source.empty() && fs::equivalent(source, file, missing))
                throw InputError(source, 0,
                                 "the run would write over this file, which it reads; expected another folder for "
                                 "--out, or a copy of the file");
        }
}

size_t RunFolder::clear() {
    size_t removed = 0;
    for (const fs::path& file : runFilesIn(folder_)) {
        std::error_code failure;
        if (!fs::is_regular_file(fs::symlink_status(file, failure))) continue;
        if (!fs::remove(file, failure))
            throw InputError(file, 0, "an earlier run's file cannot be removed; expected write permission");
        ++removed;
    }
    return removed;
}

} // namespace meltpool
