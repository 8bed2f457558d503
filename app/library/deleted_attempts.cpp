#include "app/library/deleted_attempts.hpp"

#include "app/library/attempt_title.hpp"
#include "core/base/error.hpp"

#include <string>
#include <system_error>

namespace meltpool {

namespace fs = std::filesystem;

namespace {

bool taken(const fs::path& file) {
    std::error_code missing;
    return fs::exists(fs::symlink_status(file, missing));
}

fs::path freeName(const fs::path& wanted) {
    fs::path name = wanted;
    for (int number = 2; taken(name) || taken(titleFile(name)); ++number)
        name.replace_filename(wanted.stem().string() + "-" + std::to_string(number) + wanted.extension().string());
    return name;
}

/// Moves the recording, then its name: without its name an attempt is still whole.
void moveAttempt(const fs::path& from, const fs::path& to) {
    std::error_code failure;
    fs::rename(from, to, failure);
    if (failure)
        throw InputError(from, 0,
                         "cannot be moved to " + to.string() + ": " + failure.message() +
                             "; expected write permission in both folders");
    fs::rename(titleFile(from), titleFile(to), failure);
}

} // namespace

fs::path deleteAttempt(const fs::path& recording) {
    const fs::path folder = recording.parent_path() / kDeletedFolder;
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) throw InputError(folder, 0, "cannot be created: " + failure.message() + "; expected write permission");
    const fs::path place = freeName(folder / recording.filename());
    moveAttempt(recording, place);
    return place;
}

void bringBackAttempt(const fs::path& deleted, const fs::path& place) {
    if (taken(place)) throw InputError(place, 0, "exists already; expected no file of this name");
    moveAttempt(deleted, place);
}

} // namespace meltpool
